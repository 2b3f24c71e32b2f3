#include "ideotype/crop/plant.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"
#include "ideotype/crop/leaf_surface.hpp"

namespace ideotype {

namespace {

//! Turned about the stem: an azimuth of 0 points along the row (+y), 90
//! across it (+x).
glm::dvec3 turned(const glm::dvec3& v, double sine, double cosine) {
    return {v.x * cosine + v.y * sine, v.y * cosine - v.x * sine, v.z};
}

void add_leaf(Mesh& mesh, std::uint32_t group, const LeafSurface& surface,
              double azimuth, int cells) {
    const double sine = std::sin(azimuth * degree);
    const double cosine = std::cos(azimuth * degree);
    auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const BladeRow& row : surface.tessellate(cells)) {
        mesh.vertices.push_back(turned(row.left, sine, cosine));
        mesh.vertices.push_back(turned(row.midrib, sine, cosine));
        mesh.vertices.push_back(turned(row.right, sine, cosine));
    }
    for (int cell = 0; cell < cells; ++cell, first += 3)
        for (const std::uint32_t i : {first, first + 1}) {
            mesh.faces.push_back({i, i + 1, i + 4, i + 3});
            mesh.face_group.push_back(group);
        }
}

//! A prism whose perimeter times height is the side of the cylinder, closed
//! by a flat top.
void add_stalk(Mesh& mesh, std::uint32_t group, const StalkForm& stalk,
               int sides) {
    const auto n = static_cast<std::uint32_t>(sides);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const double half_angle = std::numbers::pi / sides;
    const double radius =
        stalk.diameter / 2 * half_angle / std::sin(half_angle);
    for (std::uint32_t i = 0; i < n; ++i) {
        const double a = 2 * half_angle * i;
        const double x = radius * std::cos(a), y = radius * std::sin(a);
        mesh.vertices.push_back({x, y, 0});
        mesh.vertices.push_back({x, y, stalk.height});
    }
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({0, 0, stalk.height});
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = first + 2 * i;
        const std::uint32_t b = first + 2 * ((i + 1) % n);
        mesh.faces.push_back({a, b, b + 1, a + 1});
        mesh.faces.push_back({a + 1, b + 1, top, top});
        mesh.face_group.insert(mesh.face_group.end(), 2, group);
    }
}

std::string leaf_name(std::size_t index) {
    return fmt::format("leaf{:02}", index + 1);
}

}  // namespace

Mesh build_plant(const Plant& plant) {
    const auto& [form, traits, tessellation] = plant;
    if (traits.size() != form.leaves.size())
        throw Error(
            fmt::format("a plant has {} leaves, but traits are given for {}",
                        form.leaves.size(), traits.size()));
    Mesh mesh;
    for (std::size_t i = 0; i < traits.size(); ++i) {
        mesh.groups.push_back({leaf_name(i), Tissue::leaf});
        add_leaf(mesh, static_cast<std::uint32_t>(i),
                 LeafSurface(traits[i], form.leaves[i], form.blade),
                 traits[i].azimuth, tessellation.cells_along);
    }
    if (form.stalk.is_present) {
        mesh.groups.push_back({"stalk", Tissue::stalk});
        add_stalk(mesh, static_cast<std::uint32_t>(mesh.groups.size() - 1),
                  form.stalk, tessellation.stalk_sides);
    }
    return mesh;
}

}  // namespace ideotype
