// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ideotype {

//! The points at which a beam is looked at, which are those of a lattice that
//! repeats with the cell of a stand. It has rank 1: pixel k is at k `step_one`,
//! for k = 0, 1, ... pixels - 1. A pixel is the parallelogram along the two
//! shortest steps of this lattice, as the light sees them; in it are points (j,
//! generator j) / fine, so that all together are a finer lattice.
//!
//! No number of pixels or of points in one has a factor that the numbers of
//! rows or plants in a cell are likely to have: else plants would be looked at
//! in the same places, and their errors would not average out.
struct BeamLattice {
    std::int64_t pixels = 1;
    int fine = 1, generator = 1;
    glm::dvec2 step_one{0};           //!< from each pixel to the next [m]
    glm::dvec2 step_u{0}, step_v{0};  //!< shortest, v to the left of u [m]
    //! Numbers of the pixels that steps lead to.
    std::int64_t number_u = 0, number_v = 0;

    std::int64_t points() const { return pixels * fine; }
};

//! Returns a lattice of at least so many points: of those that some generators
//! make, the one whose shortest step is longest.
//! @param lanes points for which a pixel has room
BeamLattice beam_lattice(double period_x, double period_y, std::int64_t points,
                         int lanes, const glm::dvec3& direction);

}  // namespace ideotype
