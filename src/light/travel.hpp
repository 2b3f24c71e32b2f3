#pragma once

#include "ideotype/light/scene.hpp"

namespace ideotype {

//! A packet of light on its way.
struct PhotonPacket {
    glm::dvec3 position;
    glm::dvec3 direction;
    double energy = 0;
    bool is_scattered = false;  //!< has met a surface
};

enum class Met { face, soil, sky };

//! Straight on until the packet meets something, however far that is. In a
//! periodic stand it re-enters the cell on its other side whenever it leaves;
//! a packet that leaves an isolated plot finds only soil or sky.
Met travel(const Scene& scene, PhotonPacket& packet, Hit& hit);

}  // namespace ideotype
