// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "population.hpp"

namespace ideotype {

//! Free genes that have a range as coordinates without bounds, in units of
//! their range. Circular genes are unwrapped: all whole turns are the same
//! value. Other genes follow their coordinate, but for 5 % of the range beside
//! each bound, where they approach it smoothly and turn back: neither a value
//! nor a slope jumps.
class UnboundedGenes {
  public:
    explicit UnboundedGenes(const GeneSpace& genes);

    std::size_t size() const { return free_.size(); }

    //! Returns the coordinates of a genome within its bounds, each that nearest
    //! to 0.
    std::vector<double> of(const Genome& genome) const;

    //! Returns relative standard deviations that a search begins with: a
    //! circular gene has half of that of others, since it can go both ways
    //! round.
    std::vector<double> first_steps() const;

    //! Returns a copy of a genome with its free genes at these coordinates,
    //! each within [lower, upper], or [lower, upper) if it is circular.
    Genome genome(const std::vector<double>& coordinates,
                  Genome original) const;

  private:
    GeneSpace genes_;
    std::vector<std::size_t> free_;
};

}  // namespace ideotype
