// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Dense>

#include "response_surface.hpp"
#include "search/population.hpp"
#include "search/unbounded_genes.hpp"

namespace ideotype {

//! A local search by response surfaces within a trust region, for one objective
//! under noise (STRONG: Chang, Hong and Wan 2013, doi:10.1287/ijoc.1120.0528),
//! in the coordinates of UnboundedGenes. A generation consists of the centre,
//! the previous centre, and opposite pairs of points around the centre, which
//! separate slopes from curvatures (mirrored sampling: Brockhoff et al. 2010,
//! doi:10.1007/978-3-642-15844-5_2). The rows of a generation have common
//! random numbers. A surface is fitted to all rows, older generations with less
//! weight, and the centre moves to its maximum in the region, a ball. The next
//! generation compares both centres: the region shrinks if less than a quarter
//! of the predicted gain was found, and grows if more than three quarters were
//! and the region limited the step. The spread of points changes with it.
class SurfaceArm {
  public:
    //! @param start first centre; free genes are real
    //! @param pairs number of pairs of points in a generation, > 0
    SurfaceArm(const UnboundedGenes& coordinates, const Genome& start,
               std::size_t pairs);

    //! Returns the number of rows of the next generation.
    std::size_t size() const { return count_centres() + 2 * pairs_; }

    //! Returns the plant of a row of the next generation.
    Candidate candidate(std::uint64_t seed, std::uint32_t generation,
                        std::uint32_t slot, const Genome& baseline) const;

    //! Learns the rows of a generation; failed ones are ignored. The surface is
    //! that of the objective, without constraints. The arguments are the same
    //! as in candidate().
    void learn(const Population& rows, Sense sense, std::uint64_t seed,
               std::uint32_t generation);

    //! Returns the number of generations learnt.
    std::size_t generations() const { return generations_; }

    //! Returns the plant at the centre.
    Candidate centre(const Genome& baseline) const;

    //! Returns the centre in coordinates.
    const Eigen::VectorXd& mean() const { return centre_; }
    //! Returns the standard deviations of points about the centre.
    Eigen::VectorXd deviations() const { return radius_ * scales_; }

  private:
    //! Returns the number of rows before the pairs: the centre and, after the
    //! first generation, the previous centre.
    std::uint32_t count_centres() const { return generations_ == 0 ? 1 : 2; }

    Eigen::VectorXd point(std::uint64_t seed, std::uint32_t generation,
                          std::uint32_t slot) const;
    Candidate make_candidate(const Eigen::VectorXd& point,
                             const Genome& baseline) const;
    void adapt_region(double gain);
    void move();

    UnboundedGenes coordinates_;
    std::size_t pairs_;
    Eigen::VectorXd centre_, previous_;
    Eigen::VectorXd scales_;  //!< deviations at radius 1
    double radius_ = 1;
    double predicted_ = 0;     //!< gain of the centre over the previous one
    bool is_limited_ = false;  //!< whether the region limited the last step
    std::size_t generations_ = 0;
    std::vector<SurfaceRows> rows_;  //!< of each generation, oldest first
};

}  // namespace ideotype
