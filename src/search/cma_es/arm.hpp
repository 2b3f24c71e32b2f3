// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dd_cma.hpp"
#include "search/population.hpp"
#include "search/unbounded_genes.hpp"

namespace ideotype {

//! A search by dd-CMA-ES in the coordinates of UnboundedGenes. Plants are
//! ranked by is_better(), so feasible plants come first.
class Arm {
  public:
    Arm(const UnboundedGenes& coordinates, const Genome& start,
        std::size_t population);

    std::size_t population() const { return population_; }
    const DdCma& distribution() const { return distribution_; }
    //! Returns the mean of objective 0 over the better half, for each
    //! generation.
    const std::vector<double>& course() const { return course_; }

    //! Returns the point of one of the arm's plants in a generation. The points
    //! of a generation are drawn when the first of them is used.
    //! @param slot slot of the arm's first plant in the generation
    //! @param plant index of the plant in the arm
    const Eigen::VectorXd& point(std::uint64_t seed, std::uint32_t generation,
                                 std::uint32_t slot, std::size_t plant);

    //! Doubles the number of plants, and discards the recorded means.
    void grow();

    //! Updates the distribution with the evaluated plants of the arm. The
    //! arguments are the same as in point().
    void learn(const Population& rows, const std::vector<Sense>& senses,
               std::uint64_t seed, std::uint32_t generation,
               std::uint32_t slot);

    //! Returns the largest standard deviation of the distribution.
    double extent() const { return distribution_.deviations().maxCoeff(); }

    //! Compares the mean of the last generations with the mean of as many
    //! generations before them. Returns whether the gain is at most the
    //! standard error of the difference.
    bool gains_nothing(Sense sense) const;

  private:
    std::size_t population_;
    DdCma distribution_;
    std::vector<Eigen::VectorXd> points_;  //!< points of the next generation
    std::vector<double> course_;
};

//! Makes the candidate at a point.
Candidate make_candidate(const Eigen::VectorXd& point,
                         const UnboundedGenes& coordinates,
                         const Genome& baseline);

}  // namespace ideotype
