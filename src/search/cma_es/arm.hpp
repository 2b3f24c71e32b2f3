// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dd_cma.hpp"
#include "search/population.hpp"
#include "search/unbounded_genes.hpp"

namespace ideotype {

//! A search by dd-CMA-ES over the UnboundedGenes of the free genes. Plants are
//! ranked by is_better(), so that feasible plants come first.
class Arm {
  public:
    Arm(const UnboundedGenes& coordinates, const Genome& start,
        std::size_t population);

    std::size_t population() const { return population_; }
    const DdCma& distribution() const { return distribution_; }
    //! Returns the mean of each generation's better half, see better_half().
    const std::vector<double>& course() const { return course_; }

    //! Returns the point of one of the arm's plants in a generation, where
    //! `slot` is that of the first plant. The point is drawn at its first use.
    const Eigen::VectorXd& point(std::uint64_t seed, std::uint32_t generation,
                                 std::uint32_t slot, std::size_t plant);

    //! Doubles the number of the arm's plants, and begins its course anew.
    void grow();

    //! Learns from the rows of the arm's plants; arguments are as in point().
    void learn(const Population& rows, const std::vector<Sense>& senses,
               std::uint64_t seed, std::uint32_t generation,
               std::uint32_t slot);

    //! Returns the largest standard deviation of the distribution.
    double extent() const { return distribution_.deviations().maxCoeff(); }

    //! Returns whether the last generations exceed as many before them by no
    //! more than the standard error of the difference.
    bool gains_nothing(Sense sense) const;

  private:
    std::size_t population_;
    DdCma distribution_;
    std::vector<Eigen::VectorXd> points_;  //!< drawn for the next generation
    std::vector<double> course_;
};

//! Returns the plant at a point.
Candidate plant_at(const Eigen::VectorXd& point,
                   const UnboundedGenes& coordinates, const Genome& baseline);

}  // namespace ideotype
