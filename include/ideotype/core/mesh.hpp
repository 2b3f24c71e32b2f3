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
    //! The component of the scene by number; fixed objects follow components.
    std::uint32_t component = 0;
    //! Organ by number: 0 is the leaves, others count from 1.
    std::uint32_t organ = 0;
    //! Leaf rank from the lowest, 1; 0 if it is unknown.
    std::uint32_t rank = 0;
    //! Part of the organ, such as a face; 0 is all of the organ.
    std::uint32_t part = 0;

    bool is_leaf() const { return organ == 0; }

    //! The number that fixed objects have in place of an organ.
    static constexpr std::uint32_t object = ~std::uint32_t{0};
    bool is_object() const { return organ == object; }
};

//! Faces whose light is counted together, for example all leaves of one rank.
struct Group {
    std::string name;  //!< for people; nothing is read from it
    SurfaceId id{};
    std::uint32_t material = 0;  //!< index into Optics::materials
    //! Number of the pose of a surface that moves with the sun, which only
    //! light from sources of this pose meets; 0 for fixed surfaces.
    std::uint32_t pose = 0;
    bool is_green = false;  //!< whether an organ besides leaves assimilates

    //! Returns whether the surface assimilates if plants of its component do.
    bool assimilates() const { return id.is_leaf() || is_green; }
};

//! Surfaces as quadrilaterals with vertices in [m], z up. A triangle repeats
//! its last vertex.
struct Mesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 4>> faces;
    std::vector<std::uint32_t> face_group;  //!< index into groups, per face
    std::vector<Group> groups;
};

//! Returns the one-sided area of each face [m2].
std::vector<double> face_areas(const Mesh& mesh);

//! The area of plants, half of their surface [m2].
struct PlantArea {
    double leaves = 0;  //!< the one-sided area of leaves
    //! Half of the outer surface of other organs, which are solid.
    double other_organs = 0;

    PlantArea& operator+=(const PlantArea& more) {
        leaves += more.leaves;
        other_organs += more.other_organs;
        return *this;
    }
};

//! Returns the area of all faces of a mesh except those of fixed objects.
PlantArea plant_area(const Mesh& mesh);

}  // namespace ideotype
