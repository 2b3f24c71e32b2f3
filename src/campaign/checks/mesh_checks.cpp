// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/meshes.hpp"
#include "checks.hpp"

namespace ideotype {

namespace {

//! The largest number of faces of one plant. It is limited because histories
//! store meshes as text.
constexpr std::size_t most_faces = 100'000;

//! Reports surfaces without material, and meshes with too many faces.
void check_surfaces(const ComponentMesh& mesh, const Problems& problems) {
    problems.rule({"mesh"}, mesh.face_groups.empty() || !is_whole(mesh),
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

//! Reports values that are not valid optical properties.
//! @param table name of the table that contains the key of the waveband
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
    // The sum of decimal fractions such as 0.7 and 0.3 may exceed 1 by
    // rounding.
    problems.rule({band}, sum > 1 + 1e-12,
                  "{}.{} scatters {} of the light (more than 1); reflectance "
                  "and transmittance sum to 1 at most",
                  table, band, sum);
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

void check_materials(const std::vector<MaterialSpec>& materials,
                     const std::vector<std::string>& bands,
                     const std::string& table, const Problems& problems) {
    for (std::size_t m = 0; m < materials.size(); ++m) {
        const Problems of_material = problems.in("material", m);
        for (const std::string& band : bands)
            if (of_material.usable({band}) && materials[m].in(band).empty())
                of_material.add_at(
                    of_material.where("groups"), "groups", ProblemCode::missing,
                    "the material of groups {} has no {} (light is "
                    "followed in it); add {} = [0.06, 0.03]",
                    fmt::join(materials[m].groups, ", "), band, band);
        for (const std::string& band : bands_of({materials[m]}))
            check_optical_parts(materials[m].in(band), table, band,
                                of_material);
    }
}

void read_meshes(const std::string& file, Spec& spec,
                 const Problems& problems) {
    for (std::size_t i = 0; i < spec.objects.size(); ++i)
        read_content(spec.objects[i].mesh, "obj", file,
                     problems.in("object", i));
    for (std::size_t i = 0; i < spec.components.size(); ++i)
        read_content(spec.components[i].mesh, "mesh", file,
                     problems.in("component", i));
}

void check_component_meshes(const Spec& spec, const Problems& problems) {
    std::vector<std::string> followed;
    for (std::size_t b = 0; b < wavebands.size(); ++b)
        if (followed_bands(spec)[b]) followed.push_back(wavebands[b].name);
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        const ComponentSpec& component = spec.components[i];
        const Problems of_component = problems.in("component", i);
        if (!component.has_mesh() || !of_component.usable({"mesh"})) continue;
        check_materials(component.mesh.materials, followed,
                        "component.material", of_component);
        for (std::size_t m = 0; m < component.mesh.materials.size(); ++m)
            for (const auto& [band, parts] : component.mesh.materials[m].others)
                of_component.in("material", m)
                    .add(band, ProblemCode::unknown_key,
                         "component.material.{} is not a waveband of "
                         "campaigns; use par or nir",
                         band);
        of_component.rule(
            {"mesh"}, spec.water.has_value(),
            "component.mesh is given (water exchange of meshes is not "
            "modelled); leave out [water]");
        if (component.mesh.photosynthesis)
            check_photosynthesis(*component.mesh.photosynthesis, 0,
                                 of_component);
        check_surfaces(component.mesh, of_component);
        if (of_component.usable({"mesh"}) &&
            problems.usable({"field.rows", "field.plants", "field.boundary"}))
            check_size(component, spec, of_component);
    }
}

}  // namespace ideotype
