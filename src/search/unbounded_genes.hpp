// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "population.hpp"

namespace ideotype {

//! The initial standard deviation of a search, relative to the range of a gene.
inline constexpr double first_step = 0.2;

//! Coordinates without bounds for the free genes that have a range, in units of
//! the range. A circular gene is unwrapped: whole turns do not change its
//! value. A real gene equals its coordinate, except in the 5 % of the range
//! next to each bound. There, as the coordinate passes the bound, the value
//! approaches the bound smoothly and then moves back into the range, without a
//! jump in value or slope. The values of an integer gene have equal parts of
//! the range, and the outer ones also everything beyond. Choices have no
//! coordinates.
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

    //! Returns a copy of a genome in which the free genes with coordinates are
    //! set from these. They lie within [lower, upper], or within [lower, upper)
    //! for circular genes.
    Genome to_genome(const std::vector<double>& coordinates,
                     Genome original) const;

    const GeneSpace& genes() const { return genes_; }
    //! Returns the gene of each coordinate.
    const std::vector<std::size_t>& free() const { return free_; }
    //! Returns the free genes that are choices.
    const std::vector<std::size_t>& choices() const { return choices_; }

  private:
    GeneSpace genes_;
    std::vector<std::size_t> free_, choices_;
};

}  // namespace ideotype
