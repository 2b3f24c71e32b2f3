// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "population.hpp"

namespace ideotype {

//! Coordinates without bounds for the free genes that have a range, in units of
//! the range. Circular genes are unwrapped: whole turns do not change the
//! value. Other genes equal their coordinate except within 5 % of the range at
//! a bound. There they approach the bound smoothly and turn back, without a
//! jump of value or slope.
class UnboundedGenes {
  public:
    explicit UnboundedGenes(const GeneSpace& genes);

    //! Converts a genome within its bounds to coordinates. If several
    //! coordinates give a value, the one nearest to 0 is used.
    std::vector<double> to_coordinates(const Genome& genome) const;

    //! Returns the initial standard deviations of a search in relative units.
    //! Circular genes use half of the usual value, since they can move in both
    //! directions.
    std::vector<double> first_steps() const;

    //! Returns a copy of a genome in which the free genes are set from
    //! coordinates. They lie within [lower, upper], or within [lower, upper)
    //! for circular genes.
    Genome to_genome(const std::vector<double>& coordinates,
                     Genome original) const;

  private:
    GeneSpace genes_;
    std::vector<std::size_t> free_;
};

}  // namespace ideotype
