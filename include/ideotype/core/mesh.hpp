// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace ideotype {

//! What a surface is made of; selects its optical properties.
enum class Tissue : std::uint8_t { leaf, stalk, sheath };

//! Faces whose light is counted together, for example all leaves of one rank.
struct Group {
    std::string name;
    Tissue tissue = Tissue::leaf;
};

//! Surfaces as quadrilaterals [m], z up. A triangle repeats its last vertex.
struct Mesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 4>> faces;
    std::vector<std::uint32_t> face_group;  //!< index into groups, per face
    std::vector<Group> groups;
};

//! One-sided area of each face [m2].
std::vector<double> face_areas(const Mesh& mesh);

//! Half of the surface of plants [m2].
struct PlantArea {
    double leaves = 0;        //!< which is their one-sided area
    double other_organs = 0;  //!< half of what is outside, since they are solid
};

//! The area of all faces of a mesh.
PlantArea plant_area(const Mesh& mesh);

}  // namespace ideotype
