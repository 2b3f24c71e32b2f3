#pragma once

#include "ideotype/light/scene.hpp"

namespace ideotype {

//! A bundle of light on its way.
struct Bundle {
    glm::dvec3 position;
    glm::dvec3 direction;
    double energy = 0;
    bool is_scattered = false;  //!< has met a surface
};

enum class Met { face, soil, sky };

//! Straight on until the bundle meets something, however far that is. In a
//! periodic stand it re-enters the cell on its other side whenever it leaves;
//! a bundle that leaves an isolated plot finds only soil or sky.
Met travel(const Scene& scene, Bundle& bundle, Hit& hit);

}  // namespace ideotype
