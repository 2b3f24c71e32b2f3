// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ideotype {

//! The points at which a beam is sampled: a lattice that repeats with the cell
//! of a stand. The lattice has rank 1: pixel k is at k `step_one`, for k = 0,
//! 1, ... pixels - 1. A pixel is the parallelogram along the two shortest steps
//! of the lattice, as seen along the light. The points (j, generator j) / fine
//! in all pixels form a finer lattice. The numbers of pixels and of points per
//! pixel avoid factors that the numbers of rows or plants in a cell are likely
//! to contain. With such factors, all plants would be sampled at the same
//! positions and errors would not average out.
struct BeamLattice {
    std::int64_t pixels = 1;
    int fine = 1, generator = 1;
    glm::dvec2 step_one{0};  //!< step from each pixel to the next [m]
    //! Shortest steps; v is to the left of u [m].
    glm::dvec2 step_u{0}, step_v{0};
    std::int64_t number_u = 0, number_v = 0;  //!< pixels at step_u and step_v

    std::int64_t points() const { return pixels * fine; }
};

//! Returns a lattice with at least a given number of points. Several generators
//! are tested; the lattice with the longest shortest step is returned.
//! @param lanes number of points per pixel for which there is space
BeamLattice beam_lattice(double period_x, double period_y, std::int64_t points,
                         int lanes, const glm::dvec3& direction);

}  // namespace ideotype
