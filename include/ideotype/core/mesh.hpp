// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace ideotype {

//! Identifies the part of a plant or object that a surface belongs to.
struct SurfaceId {
    //! Number of the component in the scene. Numbers of fixed objects follow
    //! those of components.
    std::uint32_t component = 0;
    //! Number of the organ: 0 for leaves, from 1 for other organs.
    std::uint32_t organ = 0;
    //! Rank of the leaf, 1 for the lowest; 0 if unknown.
    std::uint32_t rank = 0;
    //! Part of the organ, such as a face; 0 for the whole organ.
    std::uint32_t part = 0;

    bool is_leaf() const { return organ == 0; }

    //! The organ number of fixed objects.
    static constexpr std::uint32_t object = ~std::uint32_t{0};
    bool is_object() const { return organ == object; }
};

//! A set of faces with a common sum of light, for example all leaves of one
//! rank.
struct Group {
    std::string name;  //!< for people only, never parsed
    SurfaceId id{};
    std::uint32_t material = 0;  //!< index into Optics::materials
    //! Orientation index of a surface that moves with the sun; only light
    //! sources with the same index reach the surface. 0 for fixed surfaces.
    std::uint32_t pose = 0;
    bool is_green = false;  //!< whether an organ other than a leaf assimilates

    //! Returns whether the surface assimilates if the component does.
    bool assimilates() const { return id.is_leaf() || is_green; }
};

//! Surfaces as quadrilaterals with vertices in [m], z up. Triangles repeat
//! their last vertex.
struct Mesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 4>> faces;
    std::vector<std::uint32_t> face_group;  //!< index into groups, per face
    std::vector<Group> groups;
};

//! Returns the one-sided area of each face [m2].
std::vector<double> face_areas(const Mesh& mesh);

//! The area of plants: half of their total surface [m2].
struct PlantArea {
    double leaves = 0;  //!< one-sided area of leaves
    //! Half of the outer surface of other organs, which are solid.
    double other_organs = 0;

    PlantArea& operator+=(const PlantArea& more) {
        leaves += more.leaves;
        other_organs += more.other_organs;
        return *this;
    }
};

//! Sums the area of all faces of a mesh, except those of fixed objects.
PlantArea plant_area(const Mesh& mesh);

}  // namespace ideotype
