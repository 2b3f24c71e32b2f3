// SPDX-License-Identifier: Apache-2.0
#include "meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ideotype/core/units.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "spec/files.hpp"

namespace ideotype {

namespace {

//! The largest width of a face relative to the cell. Rays test the periodic
//! images of a wide face one by one, so the time is proportional to this width.
constexpr double most_periods = 100;

//! The largest number of periods that a path may cross before it leaves the
//! canopy.
constexpr double most_crossings = 1000;

//! Returns the extent of a face along an axis [m].
double width(const Mesh& mesh, const std::array<std::uint32_t, 4>& face,
             double glm::dvec3::*axis) {
    const auto [least, largest] = std::minmax(
        {mesh.vertices[face[0]].*axis, mesh.vertices[face[1]].*axis,
         mesh.vertices[face[2]].*axis, mesh.vertices[face[3]].*axis});
    return largest - least;
}

//! Returns vertices, faces and, if known, the group of each face.
Mesh surfaces_of(const MeshContent& content) {
    Mesh mesh;
    const std::vector<double>&at = content.vertices, &corners = content.faces;
    for (std::size_t i = 0; i + 2 < at.size(); i += 3)
        mesh.vertices.push_back({at[i], at[i + 1], at[i + 2]});
    for (std::size_t i = 0; i + 3 < corners.size(); i += 4) {
        auto& face = mesh.faces.emplace_back();
        for (std::size_t k = 0; k < face.size(); ++k)
            face[k] = static_cast<std::uint32_t>(corners[i + k]);
    }
    for (const double group : content.face_groups)
        mesh.face_group.push_back(static_cast<std::uint32_t>(group));
    return mesh;
}

//! Returns whether all numbers are integers from 0 to below a limit.
bool are_below(const std::vector<double>& numbers, std::size_t limit) {
    return std::ranges::all_of(numbers, [&](double x) {
        return x >= 0 && x < static_cast<double>(limit) && x == std::floor(x);
    });
}

Material material_of(const std::vector<double>& parts) {
    return parts.size() == 2 ? Material(parts[0], parts[1])
                             : Material(parts[0], parts[1], parts[2]);
}

}  // namespace

Mesh mesh_of(const ObjectEntry& object) {
    const double sine = std::sin(object.turn * degree);
    const double cosine = std::cos(object.turn * degree);
    Mesh mesh = surfaces_of(object.mesh);
    mesh.groups = {{object.name, {0, SurfaceId::object}}};
    mesh.face_group.assign(mesh.faces.size(), 0);
    for (glm::dvec3& x : mesh.vertices)
        x = {object.x + x.x * cosine + x.y * sine,
             object.y + x.y * cosine - x.x * sine, object.z + x.z};
    return mesh;
}

Mesh mesh_of(const MeshContent& content) {
    Mesh mesh = surfaces_of(content);
    for (const std::string& name : content.groups)
        mesh.groups.push_back({name});
    number_groups(mesh);
    return mesh;
}

void add_surfaces(const std::vector<MaterialSpec>& materials, Mesh& mesh,
                  Bands& bands) {
    const std::size_t first = bands.front().optics.materials.size();
    for (Group& group : mesh.groups)
        group.material = static_cast<std::uint32_t>(
            first + first_that_fits(materials, group.name));
    for (Band& band : bands)
        for (const MaterialSpec& each : materials)
            band.optics.materials.push_back(material_of(each.in(band.name)));
}

void add_surfaces(const ByBand<Lambertian>& optics, Mesh& mesh, Bands& bands) {
    MaterialSpec material{.groups = {""}, .optics = {}};
    for (std::size_t b = 0; b < wavebands.size(); ++b)
        material.optics[b] = {optics[b].reflectance, optics[b].transmittance};
    add_surfaces({material}, mesh, bands);
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
    Range range{none, -none};
    for (const auto& face : mesh.faces)
        for (const std::uint32_t vertex : face) {
            const double z = mesh.vertices[vertex].z;
            range = {std::min(range.lower, z), std::max(range.upper, z)};
        }
    return range;
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

void read_content(MeshContent& content, const std::string& key,
                  const std::string& folder, const Problems& problems) try {
    if (content.file.empty() || !content.vertices.empty() ||
        !problems.usable({key}))
        return;
    const Mesh mesh = read_obj(path_from(folder, content.file)).mesh;
    for (const glm::dvec3& v : mesh.vertices)
        content.vertices.insert(content.vertices.end(), {v.x, v.y, v.z});
    for (const auto& face : mesh.faces)
        content.faces.insert(content.faces.end(), face.begin(), face.end());
    for (const Group& group : mesh.groups) content.groups.push_back(group.name);
    content.face_groups.assign(mesh.face_group.begin(), mesh.face_group.end());
} catch (const InputError& error) {
    problems.spoil(key);
    for (const Problem& problem : error.problems())
        problems.add(problems.named_by(key, problem));
} catch (const Error& error) {
    problems.add(key, ProblemCode::file,
                 "{}; give a path relative to this file", error.what());
}

bool is_whole(const MeshContent& content) {
    const std::size_t groups = content.face_groups.size();
    return content.vertices.size() % 3 == 0 && content.faces.size() % 4 == 0 &&
           !content.faces.empty() &&
           are_below(content.faces, content.vertices.size() / 3) &&
           (groups == 0 || content.faces.size() == 4 * groups) &&
           are_below(content.face_groups, content.groups.size());
}

}  // namespace ideotype
