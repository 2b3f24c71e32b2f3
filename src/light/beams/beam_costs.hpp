// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "beam_lattice.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! The times that parts of a simulation take on a usual processor [us]. They
//! are constants, so that choices by them never depend on a clock.
struct Costs {
    static constexpr double ray = 0.5;  //!< a ray to the surface that it meets
    static constexpr double point = 0.02;  //!< one more point in a depth buffer
};

//! Returns the lattice for first hits of a beam in a number of randomisations.
BeamLattice lattice_of(const RayScene& scene, const glm::dvec3& direction,
                       std::uint32_t first_hits, int randomisations);

//! Returns the number of randomisations that should share a depth buffer.
std::size_t replicates_together(const BeamLattice& lattice);

//! Returns the time that a depth buffer of all first hits of a beam takes [us].
double cost_of_drawing(const RayScene& scene, const glm::dvec3& direction,
                       std::uint32_t first_hits, int randomisations);

//! Returns whether a depth buffer finds the first hits of a source in less time
//! than rays. Only beams over periodic stands can be drawn.
bool is_drawn(const RayScene& scene, const Source& source,
              std::uint32_t first_hits, int randomisations);

}  // namespace ideotype
