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

//! Adds vertices and faces, each given one after the other.
void add_surfaces(const std::vector<double>& vertices,
                  const std::vector<double>& faces, Mesh& mesh) {
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3)
        mesh.vertices.push_back(
            {vertices[i], vertices[i + 1], vertices[i + 2]});
    for (std::size_t i = 0; i + 3 < faces.size(); i += 4) {
        auto& face = mesh.faces.emplace_back();
        for (std::size_t k = 0; k < face.size(); ++k)
            face[k] = static_cast<std::uint32_t>(faces[i + k]);
    }
}

}  // namespace

Mesh mesh_of(const ObjectEntry& object) {
    const double sine = std::sin(object.turn * degree);
    const double cosine = std::cos(object.turn * degree);
    Mesh mesh;
    mesh.groups = {{object.name, {0, SurfaceId::object}}};
    add_surfaces(object.vertices, object.faces, mesh);
    for (glm::dvec3& x : mesh.vertices)
        x = {object.x + x.x * cosine + x.y * sine,
             object.y + x.y * cosine - x.x * sine, object.z + x.z};
    mesh.face_group.assign(mesh.faces.size(), 0);
    return mesh;
}

Mesh mesh_of(const ComponentMesh& described) {
    Mesh mesh;
    add_surfaces(described.vertices, described.faces, mesh);
    for (const double group : described.face_groups)
        mesh.face_group.push_back(static_cast<std::uint32_t>(group));
    for (const std::string& name : described.groups)
        mesh.groups.push_back({name});
    number_groups(mesh);
    for (Group& group : mesh.groups)
        group.material = static_cast<std::uint32_t>(
            first_that_fits(described.materials, group.name));
    return mesh;
}

Material material_of(const std::vector<double>& parts) {
    return parts.size() == 2 ? Material(parts[0], parts[1])
                             : Material(parts[0], parts[1], parts[2]);
}

ByBand<std::vector<Material>> materials_of(const ComponentMesh& described) {
    ByBand<std::vector<Material>> materials;
    for (const ComponentMaterial& each : described.materials)
        for (std::size_t b = 0; b < wavebands.size(); ++b)
            if (!each.optics[b].empty())
                materials[b].push_back(material_of(each.optics[b]));
    return materials;
}

void number_groups(Mesh& mesh) {
    const bool has_ranks =
        std::ranges::any_of(mesh.groups, leaf_rank, &Group::name);
    for (Group& group : mesh.groups) {
        const std::uint32_t rank = leaf_rank(group.name);
        group.id = {0, has_ranks && rank == 0 ? 1u : 0u, rank};
    }
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

std::optional<Mesh> read_mesh(const std::string& path, const std::string& key,
                              const Problems& problems) try {
    return read_obj(path).mesh;
} catch (const InputError& error) {
    for (const Problem& problem : error.problems())
        problems.add(problems.named_by(key, problem));
    return std::nullopt;
} catch (const Error& error) {
    problems.add(key, ProblemCode::file,
                 "{}; give a path relative to this file", error.what());
    return std::nullopt;
}

void take_surfaces(const Mesh& mesh, std::vector<double>& vertices,
                   std::vector<double>& faces) {
    for (const glm::dvec3& v : mesh.vertices)
        vertices.insert(vertices.end(), {v.x, v.y, v.z});
    for (const auto& face : mesh.faces)
        faces.insert(faces.end(), face.begin(), face.end());
}

}  // namespace ideotype
