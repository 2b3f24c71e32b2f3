// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/plant.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "ideotype/core/units.hpp"
#include "leaves.hpp"

namespace ideotype {

namespace {

//! A truncated cone.
struct Frustum {
    glm::dvec3 base, top;                     //!< ends of the axis [m]
    double base_radius, top_radius;           //!< radii of both ends [m]
    glm::dvec3 right{1, 0, 0}, far{0, 1, 0};  //!< unit vectors across the axis
};

//! Adds a prism with the same perimeter as the circular cross-section. Its top
//! is closed by a flat face, unless a part that is at least as thick follows.
void add_frustum(Mesh& mesh, std::uint32_t group, const Frustum& shape,
                 int sides, bool has_top = true) {
    const auto n = static_cast<std::uint32_t>(sides);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const double half_angle = std::numbers::pi / sides;
    // A prism with `sides` faces needs a larger radius for the same perimeter.
    const auto stretched = [&](double radius) {
        return radius * half_angle / std::sin(half_angle);
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        const double a = 2 * half_angle * i;
        const glm::dvec3 out =
            std::cos(a) * shape.right + std::sin(a) * shape.far;
        mesh.vertices.push_back(shape.base +
                                stretched(shape.base_radius) * out);
        mesh.vertices.push_back(shape.top + stretched(shape.top_radius) * out);
    }
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size());
    if (has_top) mesh.vertices.push_back(shape.top);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = first + 2 * i;
        const std::uint32_t b = first + 2 * ((i + 1) % n);
        mesh.faces.push_back({a, b, b + 1, a + 1});
        mesh.face_group.push_back(group);
        if (!has_top) continue;
        mesh.faces.push_back({a + 1, b + 1, top, top});
        mesh.face_group.push_back(group);
    }
}

//! A section of the stalk between two heights [m], with the stalk or a sheath
//! as its visible surface.
struct Section {
    double lower, upper;
    bool is_sheath;
};

//! Returns the visible parts of the stalk, from the soil up.
std::vector<Section> list_sections(const Plant& plant) {
    const Sheath& sheath = plant.sheath;
    if (!sheath.is_present) return {{0, plant.stalk.height, false}};
    // Light is averaged over each surface that assimilates, so green sheaths
    // are not merged.
    const bool joins = !(sheath.capacity > 0);
    // Far above rounding errors, and in proportion to the plant, so that all
    // plants of a field have the same sections, however tall they are.
    const double shortest = 1e-6 * plant.stalk.height;
    std::vector<Section> parts;
    const auto add = [&](double upper, bool is_sheath) {
        const double lower = parts.empty() ? 0 : parts.back().upper;
        if (upper <= lower + shortest) return;
        if (joins && !parts.empty() && parts.back().is_sheath == is_sheath)
            parts.back().upper = upper;
        else
            parts.push_back({lower, upper, is_sheath});
    };
    for (const Leaf& leaf : plant.leaves) {
        add(leaf.insertion_height - sheath.length, false);
        add(leaf.insertion_height, true);
    }
    add(plant.stalk.height, false);
    return parts;
}

void add_sections(Mesh& mesh, const Plant& plant, bool is_sheath, int sides) {
    const auto group = static_cast<std::uint32_t>(mesh.groups.size() - 1);
    const double around = is_sheath ? plant.sheath.thickness : 0;
    const std::vector<Section> parts = list_sections(plant);
    for (const Section& section : parts) {
        if (section.is_sheath != is_sheath) continue;
        const bool is_last = &section == &parts.back();
        const bool is_below_sheath = !is_last && (&section + 1)->is_sheath;
        add_frustum(mesh, group,
                    {{0, 0, section.lower},
                     {0, 0, section.upper},
                     plant.stalk.radius(section.lower) + around,
                     plant.stalk.radius(section.upper) + around},
                    sides, is_last || (is_sheath && !is_below_sheath));
    }
}

//! Adds petioles and rachises. Each is a cone between two points in the plane
//! of the leaf.
void add_petioles(Mesh& mesh, const Plant& plant) {
    constexpr int sides = 4;
    const auto group = static_cast<std::uint32_t>(mesh.groups.size() - 1);
    for (const Leaf& leaf : plant.leaves) {
        const auto add = [&](const glm::dvec2& base, const glm::dvec2& tip) {
            const glm::dvec2 along = glm::normalize(tip - base);
            const auto placed = [&](const glm::dvec2& v) {
                return about_stalk(glm::dvec3(0, v.x, v.y), leaf.azimuth);
            };
            add_frustum(mesh, group,
                        {placed(base), placed(tip), plant.petiole.diameter / 2,
                         plant.petiole.diameter / 2,
                         about_stalk(glm::dvec3(1, 0, 0), leaf.azimuth),
                         placed({along.y, -along.x})},
                        sides, false);
        };
        const glm::dvec2 end = petiole_end(plant, leaf);
        Leaf node = leaf;
        node.petiole_length = 0;
        if (leaf.petiole_length > 0) add(petiole_end(plant, node), end);
        if (plant.blade.rachis_length > 0) add(end, rachis_end(plant, leaf));
    }
}

//! Adds the cones of an organ, spaced evenly about the stalk and along the
//! organ's spread.
void add_organ(Mesh& mesh, const Plant& plant, const Organ& organ) {
    const auto group = static_cast<std::uint32_t>(mesh.groups.size() - 1);
    const Leaf* leaf =
        organ.leaf > 0
            ? &plant.leaves.at(static_cast<std::size_t>(organ.leaf) - 1)
            : nullptr;
    const double foot = leaf ? leaf->insertion_height : plant.stalk.height;
    const double sine = std::sin(organ.inclination * degree);
    const double cosine = std::cos(organ.inclination * degree);
    for (int i = 0; i < organ.count; ++i) {
        const double azimuth =
            (leaf ? leaf->azimuth : 0) + 360.0 * i / organ.count;
        const double up =
            organ.count < 2 ? 0 : organ.spread * i / (organ.count - 1);
        // An organ that leans outwards begins at the stalk's surface.
        const double out = leaf ? plant.stalk.radius(foot) : 0;
        const glm::dvec3 axis =
            about_stalk(glm::dvec3{0, sine, cosine}, azimuth);
        const glm::dvec3 base =
            about_stalk(glm::dvec3{0, out, foot + organ.offset + up}, azimuth);
        add_frustum(
            mesh, group,
            {base, base + organ.length * axis, organ.base_diameter / 2,
             organ.top_diameter / 2, about_stalk(glm::dvec3{1, 0, 0}, azimuth),
             about_stalk(glm::dvec3{0, cosine, -sine}, azimuth)},
            organ.sides);
    }
}

//! Names the group of an organ so that parse_group_name() finds its material.
std::string make_group_name(const Organ& organ) {
    return (organ.material == PlantMaterial::sheath ? "sheath_" : "stalk_") +
           organ.name;
}

}  // namespace

double Stalk::radius(double z) const {
    const double at_top = top_diameter > 0 ? top_diameter : base_diameter;
    const double part = std::clamp(z / height, 0.0, 1.0);
    return (base_diameter + part * (at_top - base_diameter)) / 2;
}

std::vector<PlantOrgan> list_organs(const Plant& plant) {
    const auto cone = [](double length, double base, double top) {
        return std::numbers::pi / 12 * length *
               (base * base + base * top + top * top);
    };
    const Stalk& stalk = plant.stalk;
    const Sheath& sheath = plant.sheath;
    double sheaths = 0;
    // Volumes of sheaths, as shells around the stalk.
    for (const Leaf& leaf : plant.leaves)
        sheaths += 2 * std::numbers::pi * stalk.radius(leaf.insertion_height) *
                   std::min(sheath.length, leaf.insertion_height) *
                   (1 - leaf.hidden) * sheath.thickness;
    std::vector<PlantOrgan> organs{
        {"stalk", stalk.is_present, stalk,
         cone(stalk.height, 2 * stalk.radius(0),
              2 * stalk.radius(stalk.height))},
        {"sheath", sheath.is_present, sheath, sheaths},
        {"petiole", plant.petiole.is_present && has_petioles(plant)},
        {"dead_leaves", has_dead_leaves(plant)}};
    for (const Organ& organ : plant.organs)
        organs.push_back({organ.name, organ.is_present, organ,
                          organ.count * cone(organ.length, organ.base_diameter,
                                             organ.top_diameter)});
    for (PlantOrgan& organ : organs)
        organ.mass *= organ.is_present ? organ.tissue.density : 0;
    return organs;
}

std::vector<std::string> organ_names(const Plant& plant) {
    std::vector<std::string> names;
    for (PlantOrgan& organ : list_organs(plant))
        if (organ.is_present) names.push_back(std::move(organ.name));
    return names;
}

bool has_petioles(const Plant& plant) {
    return std::any_of(
        plant.leaves.begin(), plant.leaves.end(),
        [](const Leaf& leaf) { return leaf.petiole_length > 0; });
}

bool has_dead_leaves(const Plant& plant) {
    return std::any_of(plant.leaves.begin(), plant.leaves.end(),
                       [](const Leaf& leaf) { return leaf.dead > 0; });
}

double dead_area(const Mesh& mesh) {
    const std::vector<double> areas = face_areas(mesh);
    double sum = 0;
    for (std::size_t f = 0; f < areas.size(); ++f)
        if (mesh.groups[mesh.face_group[f]].name == dead_leaves)
            sum += areas[f];
    return sum;
}

void stack_internodes(Plant& plant) {
    double height = 0;
    for (Leaf& leaf : plant.leaves) {
        if (leaf.internode > 0) leaf.insertion_height = height + leaf.internode;
        height = leaf.insertion_height;
    }
    if (!plant.leaves.empty() && plant.leaves.back().internode > 0)
        plant.stalk.height = height;
}

void set_present(Plant& plant, const std::string& organ, bool is_present) {
    if (organ == "stalk") plant.stalk.is_present = is_present;
    if (organ == "sheath") plant.sheath.is_present = is_present;
    if (organ == "petiole") plant.petiole.is_present = is_present;
    for (Organ& candidate : plant.organs)
        if (candidate.name == organ) candidate.is_present = is_present;
}

Mesh build_plant(const Plant& plant, const Tessellation& tessellation) {
    Mesh mesh;
    std::uint32_t organs = 0;
    const auto begin = [&](const std::string& name, PlantMaterial material,
                           std::uint32_t rank = 0, double capacity = 0) {
        mesh.groups.push_back({name,
                               {0, rank > 0 ? 0 : ++organs, rank},
                               static_cast<std::uint32_t>(material),
                               0,
                               capacity > 0});
        return static_cast<std::uint32_t>(mesh.groups.size() - 1);
    };
    // One group per leaf.
    for (const Leaf& leaf : plant.leaves) {
        const auto rank = static_cast<std::uint32_t>(mesh.groups.size() + 1);
        const std::uint32_t group =
            begin(fmt::format("leaf{:02}", rank), PlantMaterial::leaf, rank);
        add_leaf(mesh, group, plant, leaf, tessellation.cells_along);
    }
    // One group per organ that is present, in the order of list_organs().
    const int sides = tessellation.stalk_sides;
    if (plant.stalk.is_present) {
        begin("stalk", PlantMaterial::stalk, 0, plant.stalk.capacity);
        add_sections(mesh, plant, false, sides);
    }
    if (plant.sheath.is_present) {
        begin("sheath", PlantMaterial::sheath, 0, plant.sheath.capacity);
        add_sections(mesh, plant, true, sides);
    }
    if (plant.petiole.is_present && has_petioles(plant)) {
        begin("stalk_petiole", PlantMaterial::stalk);
        add_petioles(mesh, plant);
    }
    if (has_dead_leaves(plant)) {
        const std::uint32_t group = begin(dead_leaves, PlantMaterial::stalk);
        for (const Leaf& leaf : plant.leaves)
            add_dead_part(mesh, group, plant, leaf, tessellation.cells_along);
    }
    for (const Organ& organ : plant.organs) {
        if (!organ.is_present) continue;
        begin(make_group_name(organ), organ.material, 0, organ.capacity);
        add_organ(mesh, plant, organ);
    }
    return mesh;
}

}  // namespace ideotype
