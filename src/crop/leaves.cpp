// SPDX-License-Identifier: Apache-2.0
#include "leaves.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "ideotype/core/units.hpp"
#include "ideotype/crop/leaf_surface.hpp"

namespace ideotype {

namespace {

//! Turns a vector about the z axis.
glm::dvec3 turned(const glm::dvec3& v, double sine, double cosine) {
    return {v.x * cosine + v.y * sine, v.y * cosine - v.x * sine, v.z};
}

//! Numbers of faces along a blade and on one side of its midrib.
struct BladeCells {
    int along, across;
};

//! Returns the numbers of faces of a blade. Faces of a leaflet are nearly
//! square, so that the light varies as little within each face as their number
//! permits.
BladeCells choose_cells(const Blade& blade, int along) {
    return blade.leaflets == 1 ? BladeCells{along, 1}
                               : BladeCells{std::max(4, 2 * along / 3), 2};
}

//! A part of a blade, between two relative arc lengths.
struct BladePart {
    double begin = 0, end = 1;
};

//! Returns the number of faces along the green part of a blade.
int green_cells(const Leaf& leaf, int along) {
    if (!(leaf.dead > 0)) return along;
    const double green = 1 - leaf.hidden - leaf.dead;
    return std::clamp(
        static_cast<int>(std::lround(along * green / (1 - leaf.hidden))), 1,
        along - 1);
}

//! Adds a leaflet, or a part of it, with the length and width given by `leaf`.
//! @param base distance of the leaflet's base from the stalk's axis [m]
//! @param aside azimuth of the leaflet relative to the leaf [deg]
void add_leaflet(Mesh& mesh, std::uint32_t group, const Leaf& leaf,
                 const Blade& blade, double base, double aside,
                 BladeCells cells, BladePart part) {
    constexpr double shortest = 1e-6;  // far above rounding errors
    if (!(part.end - part.begin > shortest)) return;
    const LeafSurface surface(leaf, blade, base);
    const double sine = std::sin(leaf.azimuth * degree);
    const double cosine = std::cos(leaf.azimuth * degree);
    const auto placed = [&](glm::dvec3 v) {
        if (aside != 0) {
            const glm::dvec3 foot(0, base, 0);
            v = foot + about_stalk(v - foot, aside);
        }
        return turned(v, sine, cosine);
    };
    auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const BladeRow& row :
         surface.tessellate(cells.along, part.begin, part.end))
        for (int k = -cells.across; k <= cells.across; ++k)
            mesh.vertices.push_back(placed(
                glm::mix(row.midrib, k < 0 ? row.left : row.right,
                         std::abs(k) / static_cast<double>(cells.across))));
    const auto columns = static_cast<std::uint32_t>(2 * cells.across);
    for (int cell = 0; cell < cells.along; ++cell, first += columns + 1)
        for (std::uint32_t i = first; i < first + columns; ++i) {
            mesh.faces.push_back({i, i + 1, i + columns + 2, i + columns + 1});
            mesh.face_group.push_back(group);
        }
}

}  // namespace

glm::dvec3 about_stalk(const glm::dvec3& v, double azimuth) {
    return turned(v, std::sin(azimuth * degree), std::cos(azimuth * degree));
}

glm::dvec2 petiole_end(const Plant& plant, const Leaf& leaf) {
    const double out =
        plant.stalk.is_present ? plant.stalk.radius(leaf.insertion_height) : 0;
    const double angle = leaf.petiole_angle * degree;
    return {out + leaf.petiole_length * std::sin(angle),
            leaf.insertion_height + leaf.petiole_length * std::cos(angle)};
}

glm::dvec2 rachis_end(const Plant& plant, const Leaf& leaf) {
    const double angle = leaf.insertion_angle * degree;
    return petiole_end(plant, leaf) +
           plant.blade.rachis_length *
               glm::dvec2(std::sin(angle), std::cos(angle));
}

void add_leaf(Mesh& mesh, std::uint32_t group, const Plant& plant,
              const Leaf& leaf, int cells_along) {
    const Blade& blade = plant.blade;
    for (int i = 0; i < blade.leaflets; ++i) {
        const double steps = i - (blade.leaflets - 1) / 2.0;
        const glm::dvec2 base =
            steps == 0 ? rachis_end(plant, leaf) : petiole_end(plant, leaf);
        Leaf leaflet = leaf;
        leaflet.insertion_height = base.y;
        add_leaflet(mesh, group, leaflet, blade, base.x,
                    steps * blade.leaflet_divergence,
                    choose_cells(blade, green_cells(leaf, cells_along)),
                    {leaf.hidden, 1 - leaf.dead});
    }
}

void add_dead_part(Mesh& mesh, std::uint32_t group, const Plant& plant,
                   const Leaf& leaf, int cells_along) {
    if (!(leaf.dead > 0)) return;
    const glm::dvec2 base = rachis_end(plant, leaf);
    add_leaflet(mesh, group, leaf, plant.blade, base.x, 0,
                {cells_along - green_cells(leaf, cells_along), 1},
                {1 - leaf.dead, 1});
}

}  // namespace ideotype
