// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/meshes.hpp"
#include "checks.hpp"
#include "spec/files.hpp"

namespace ideotype {

namespace {

//! The largest number of faces of one plant, which a history contains as text.
constexpr std::size_t most_faces = 100'000;

void take_content(const Mesh& mesh, ComponentMesh& described) {
    take_surfaces(mesh, described.vertices, described.faces);
    for (const Group& group : mesh.groups)
        described.groups.push_back(group.name);
    described.face_groups.assign(mesh.face_group.begin(),
                                 mesh.face_group.end());
}

//! Returns whether all numbers count from 0 to below a limit.
bool are_below(const std::vector<double>& numbers, std::size_t limit) {
    return std::ranges::all_of(numbers, [&](double x) {
        return x >= 0 && x < static_cast<double>(limit) && x == std::floor(x);
    });
}

bool is_whole(const ComponentMesh& mesh) {
    return mesh.vertices.size() % 3 == 0 && !mesh.faces.empty() &&
           mesh.faces.size() == 4 * mesh.face_groups.size() &&
           are_below(mesh.faces, mesh.vertices.size() / 3) &&
           are_below(mesh.face_groups, mesh.groups.size());
}

//! Reports a material that is not known in each band, or sends on too much.
void check_material(const ComponentMaterial& material, const Spec& spec,
                    const Problems& problems) {
    const ByBand<bool> follows = followed_bands(spec);
    for (std::size_t b = 0; b < wavebands.size(); ++b) {
        const std::vector<double>& parts = material.optics[b];
        const std::string& band = wavebands[b].name;
        problems.rule({band}, follows[b] && parts.empty(),
                      "component.material has no {} (light is followed in it); "
                      "add {} = [0.4, 0.4]",
                      band, band);
        if (!parts.empty())
            check_optical_parts(parts, "component.material", band, problems);
    }
}

//! Reports surfaces that have no material, or too many to be drawn.
void check_surfaces(const ComponentMesh& mesh, const Problems& problems) {
    problems.rule({"mesh"}, !is_whole(mesh),
                  "component.mesh has no surfaces that fit its vertices and "
                  "groups; give a file: mesh = \"tree.obj\"");
    problems.rule({"mesh"}, mesh.face_groups.size() > most_faces,
                  "component.mesh has {} faces (the limit is {}); make it "
                  "coarser",
                  mesh.face_groups.size(), most_faces);
    for (const std::string& group : mesh.groups)
        problems.rule(
            {"mesh"},
            first_that_fits(mesh.materials, group) == mesh.materials.size(),
            "group {} of component.mesh fits no "
            "[[component.material]] (none has groups that it begins "
            "with); add one",
            group);
}

//! Reports a mesh that is much larger than a field.
void check_size(const ComponentSpec& component, const Spec& spec,
                const Problems& problems) {
    const Mesh mesh = mesh_of(component.mesh);
    problems.rule({"mesh"}, heights_of(mesh).lower < -least_depth,
                  "component.mesh reaches {:.4g} m below the soil (z = 0); "
                  "lift it",
                  -heights_of(mesh).lower);
    problems.rule(
        {"mesh"},
        component.mesh.photosynthesis &&
            std::ranges::none_of(mesh.groups, &SurfaceId::is_leaf, &Group::id),
        "component.mesh has no leaves that assimilate; let names of "
        "groups end in leaf01, leaf02, ...");
    for (const NamedSpacing& spacing : spec.spacings) {
        if (!(spacing.value.row > 0 && spacing.value.plant > 0) ||
            spec.field.boundary != Boundary::periodic)
            continue;
        Cell cell;
        cell.period_x = spacing.value.row * spec.field.rows;
        cell.period_y = spacing.value.plant * spec.field.plants;
        const auto excess =
            excess_of(mesh, spec.field.rows * spec.field.plants, cell);
        problems.rule({"mesh"}, excess.has_value(),
                      "component.mesh {}; check that it is in metres",
                      excess.value_or(""));
    }
}

}  // namespace

void check_optical_parts(const std::vector<double>& parts,
                         const std::string& table, const std::string& band,
                         const Problems& problems) {
    problems.rule({band}, parts.size() < 2 || parts.size() > 3,
                  "{}.{} has {} values (expected: reflectance and "
                  "transmittance, or reflectance of the upper and the lower "
                  "face and transmittance); write {} = [0.06, 0.03]",
                  table, band, parts.size(), band);
    if (!problems.usable({band})) return;
    const double sum =
        std::max(parts[0], parts[parts.size() - 2]) + parts.back();
    // Decimal fractions such as 0.7 + 0.3 may exceed 1 by rounding.
    problems.rule({band}, sum > 1 + 1e-12,
                  "{}.{} sends on {} of the light (more than all); reflectance "
                  "and transmittance sum to 1 at most",
                  table, band, sum);
}

void read_component_meshes(const std::string& file, Spec& spec,
                           const Problems& problems) {
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        ComponentMesh& mesh = spec.components[i].mesh;
        const Problems own = problems.in("component", i);
        if (mesh.file.empty() || !mesh.vertices.empty() ||
            !own.usable({"mesh"}))
            continue;
        if (const auto found =
                read_mesh(path_from(file, mesh.file), "mesh", own))
            take_content(*found, mesh);
        else
            own.spoil("mesh");
    }
}

void check_component_meshes(const Spec& spec, const Problems& problems) {
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        const ComponentSpec& each = spec.components[i];
        const Problems own = problems.in("component", i);
        if (!each.has_mesh() || !own.usable({"mesh"})) continue;
        for (std::size_t m = 0; m < each.mesh.materials.size(); ++m)
            check_material(each.mesh.materials[m], spec, own.in("material", m));
        own.rule({"mesh"}, spec.water.has_value(),
                 "component.mesh is given (exchange of water is not known for "
                 "meshes); leave out [water]");
        if (each.mesh.photosynthesis)
            check_photosynthesis(*each.mesh.photosynthesis, 0, own);
        check_surfaces(each.mesh, own);
        if (own.usable({"mesh"}) &&
            problems.usable({"field.rows", "field.plants", "field.boundary"}))
            check_size(each, spec, own);
    }
}

}  // namespace ideotype
