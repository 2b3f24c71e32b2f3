// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "beam_lattice.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! The times of the parts of a simulation on a typical processor [us]. They are
//! constants, so that choices based on them never depend on a clock.
struct Costs {
    //! A ray up to the surface that it meets.
    static constexpr double ray = 0.5;
    //! One additional point in a depth buffer.
    static constexpr double point = 0.02;
};

//! Returns the lattice for the first hits of a beam in several randomisations.
BeamLattice lattice_of(const RayScene& scene, const glm::dvec3& direction,
                       std::uint32_t first_hits, int randomisations);

//! Returns the number of randomisations that should share one depth buffer.
std::size_t replicates_together(const BeamLattice& lattice);

//! Returns the time to compute all first hits of a beam by depth buffers [us].
double cost_of_drawing(const RayScene& scene, const glm::dvec3& direction,
                       std::uint32_t first_hits, int randomisations);

//! Returns whether a depth buffer computes the first hits of a source faster
//! than rays. Only beams over periodic stands can be rasterised.
bool is_drawn(const RayScene& scene, const Source& source,
              std::uint32_t first_hits, int randomisations);

}  // namespace ideotype
