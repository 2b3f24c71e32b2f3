// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "choice_distribution.hpp"
#include "dd_cma.hpp"
#include "integer_margin.hpp"
#include "search/population.hpp"
#include "search/unbounded_genes.hpp"

namespace ideotype {

//! A search by dd-CMA-ES in the coordinates of UnboundedGenes. Integers keep a
//! margin, and choices have categorical distributions, as in CatCMA with margin
//! (Hamano et al. 2025, arXiv:2504.07884). Plants are ranked by is_better(), so
//! feasible plants come first.
class Arm {
  public:
    //! Starts at a plant, with the usual deviations.
    Arm(const UnboundedGenes& coordinates, const Genome& start,
        std::size_t population);

    //! Starts with a mean and standard deviations > 0, in coordinates.
    Arm(const UnboundedGenes& coordinates, const Eigen::VectorXd& mean,
        const Eigen::VectorXd& deviations, std::size_t population);

    std::size_t population() const { return population_; }
    //! Returns the mean of objective 0 over the better half, for each
    //! generation.
    const std::vector<double>& course() const { return course_; }

    //! Returns one of the arm's plants in a generation. The points of a
    //! generation are drawn when the first of them is used.
    //! @param slot slot of the arm's first plant in the generation
    //! @param plant index of the plant in the arm
    //! @param baseline genome with the values of the other genes
    Candidate candidate(std::uint64_t seed, std::uint32_t generation,
                        std::uint32_t slot, std::size_t plant,
                        const Genome& baseline);

    //! Returns the plant at the mean of the distribution, with the most
    //! probable choices.
    Candidate centre(const Genome& baseline) const;

    //! Doubles the number of plants, and discards the recorded means.
    void grow();

    //! Updates the distribution with the evaluated plants of the arm. The
    //! arguments are the same as in candidate().
    void learn(const Population& rows, const std::vector<Sense>& senses,
               std::uint64_t seed, std::uint32_t generation,
               std::uint32_t slot);

    //! Returns the largest standard deviation of real genes, or infinity if
    //! there are none. Those of integers and choices have a lower limit.
    double extent() const;

    //! Compares the mean of the last generations with the mean of as many
    //! generations before them. Returns whether the gain is at most the
    //! standard error of the difference.
    bool gains_nothing(Sense sense) const;

  private:
    struct Point {
        std::vector<double> numbers;  //!< coordinates of UnboundedGenes
        ChoiceDistribution::Entries choices;
    };
    //! An integer gene.
    struct Integer {
        std::size_t coordinate;
        double count;  //!< number of values
        IntegerMargin margin;
    };

    const Point& point(std::uint64_t seed, std::uint32_t generation,
                       std::uint32_t slot, std::size_t plant);
    Candidate make_candidate(const Point& point, const Genome& baseline) const;
    void update_numbers(const std::vector<Point>& ranked);

    std::size_t population_;
    UnboundedGenes coordinates_;
    std::optional<DdCma> numbers_;  //!< none: all free genes are choices
    std::vector<Integer> integers_;
    std::optional<ChoiceDistribution> choices_;  //!< none: no gene is a choice
    std::vector<std::optional<Point>> points_;   //!< of the next generation
    std::vector<double> course_;
};

}  // namespace ideotype
