// SPDX-License-Identifier: Apache-2.0
#include "meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ideotype/core/units.hpp"
#include "ideotype/crop/obj_reader.hpp"

namespace ideotype {

namespace {

//! The largest width of a face over that of the cell. Light meets the images of
//! a wide face one by one, so its time is proportional to this width.
constexpr double most_periods = 100;

//! The most crossings of a periodic cell by light on its way out.
constexpr double most_crossings = 1000;

//! Returns the extent of a face along an axis [m].
double width(const Mesh& mesh, const std::array<std::uint32_t, 4>& face,
             double glm::dvec3::*axis) {
    const auto [least, largest] = std::minmax(
        {mesh.vertices[face[0]].*axis, mesh.vertices[face[1]].*axis,
         mesh.vertices[face[2]].*axis, mesh.vertices[face[3]].*axis});
    return largest - least;
}

}  // namespace

Mesh mesh_of(const ObjectEntry& object) {
    const double sine = std::sin(object.turn * degree);
    const double cosine = std::cos(object.turn * degree);
    Mesh mesh;
    mesh.groups = {{object.name, {0, SurfaceId::object}}};
    const std::vector<double>& v = object.vertices;
    for (std::size_t i = 0; i + 2 < v.size(); i += 3)
        mesh.vertices.push_back({object.x + v[i] * cosine + v[i + 1] * sine,
                                 object.y + v[i + 1] * cosine - v[i] * sine,
                                 object.z + v[i + 2]});
    for (std::size_t i = 0; i + 3 < object.faces.size(); i += 4) {
        auto& face = mesh.faces.emplace_back();
        for (std::size_t k = 0; k < face.size(); ++k)
            face[k] = static_cast<std::uint32_t>(object.faces[i + k]);
    }
    mesh.face_group.assign(mesh.faces.size(), 0);
    return mesh;
}

Range heights_of(const Mesh& mesh) {
    constexpr double none = std::numeric_limits<double>::infinity();
    Range all{none, -none};
    for (const auto& face : mesh.faces)
        for (const std::uint32_t vertex : face) {
            const double z = mesh.vertices[vertex].z;
            all = {std::min(all.lower, z), std::max(all.upper, z)};
        }
    return all;
}

std::optional<std::string> excess_of(const Mesh& mesh, double copies,
                                     const Cell& cell) {
    double images = 0, most_x = 0, most_y = 0;
    for (const auto& face : mesh.faces) {
        const double x = width(mesh, face, &glm::dvec3::x);
        const double y = width(mesh, face, &glm::dvec3::y);
        images += (1 + x / cell.period_x) * (1 + y / cell.period_y);
        most_x = std::max(most_x, x);
        most_y = std::max(most_y, y);
    }
    for (const auto& [axis, size, period] :
         {std::tuple('x', most_x, cell.period_x),
          std::tuple('y', most_y, cell.period_y)})
        if (size > most_periods * period)
            return fmt::format(
                "has a face of {:.6g} m along {} over a period of {:.6g} m "
                "(the limit is {:.0f} times the period)",
                size, axis, period, most_periods);
    if (!(copies * images <= most_obj_faces))
        return fmt::format(
            "covers its period of {} x {} m so often that {:.1e} faces would "
            "be needed (the limit is {:.0e})",
            cell.period_x, cell.period_y, copies * images,
            static_cast<double>(most_obj_faces));
    const double period = std::min(cell.period_x, cell.period_y);
    const double height = heights_of(mesh).upper;
    if (height > most_crossings * period)
        return fmt::format(
            "is {:.6g} m high over a period of {:.6g} m (the limit is {:.0f} "
            "times the period)",
            height, period, most_crossings);
    return std::nullopt;
}

}  // namespace ideotype
