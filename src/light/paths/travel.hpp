// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! A packet of light at a position on its path.
struct PhotonPacket {
    glm::dvec3 position;
    glm::dvec3 direction;
    double energy = 0;
    bool is_scattered = false;  //!< whether it has met a surface
};

//! Returns the first face, soil or sky along a direction, at any distance. In a
//! periodic stand, a ray that leaves the cell continues at the opposite side.
//! Outside the box of an isolated plot, light meets only soil or sky.
//! @param pose orientation index of moving objects
Hit travel(const RayScene& scene, glm::dvec3 from, const glm::dvec3& direction,
           std::uint32_t pose = 0);

}  // namespace ideotype
