// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! A packet of light on its way.
struct PhotonPacket {
    glm::dvec3 position;
    glm::dvec3 direction;
    double energy = 0;
    bool is_scattered = false;  //!< has met a surface
};

//! Returns the first thing straight on from a point, however far that is: a
//! face, the soil or the sky. In a periodic stand the way goes on at the other
//! side of the cell wherever it leaves it; light that leaves an isolated plot
//! finds only soil or sky.
//! @param pose of what moves
Hit travel(const RayScene& scene, glm::dvec3 from, const glm::dvec3& direction,
           std::uint32_t pose = 0);

}  // namespace ideotype
