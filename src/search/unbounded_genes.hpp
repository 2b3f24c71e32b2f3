// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "population.hpp"

namespace ideotype {

//! Free genes that have a range as coordinates without bounds, in units of
//! their range. Circular genes are unwrapped, so that whole turns do not change
//! the value. Other genes equal their coordinate, but within 5 % of the range
//! beside a bound they approach the bound smoothly and turn back, without a
//! jump of value or slope.
class UnboundedGenes {
  public:
    explicit UnboundedGenes(const GeneSpace& genes);

    //! Returns the coordinates of a genome within its bounds, each the nearest
    //! to 0.
    std::vector<double> of(const Genome& genome) const;

    //! Returns the relative standard deviations at the beginning of a search: a
    //! circular gene has half of the usual one, since it can move both ways
    //! round.
    std::vector<double> first_steps() const;

    //! Returns a copy of a genome with its free genes at given coordinates,
    //! each within [lower, upper], or [lower, upper) for circular genes.
    Genome genome(const std::vector<double>& coordinates,
                  Genome original) const;

  private:
    GeneSpace genes_;
    std::vector<std::size_t> free_;
};

}  // namespace ideotype
