// SPDX-License-Identifier: Apache-2.0
#include "placed_objects.hpp"

#include <cmath>
#include <utility>

#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

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

//! Adds an object with a material of its own.
void add(Scene& scene, FixedObject object, const Lambertian& par,
         const Lambertian& nir) {
    const auto material =
        static_cast<std::uint32_t>(scene.bands.front().optics.materials.size());
    for (Group& group : object.mesh.groups) group.material = material;
    for (Band& band : scene.bands) {
        const Lambertian& optics = band.name == "nir" ? nir : par;
        band.optics.materials.emplace_back(optics.reflectance,
                                           optics.transmittance);
    }
    scene.objects.push_back(std::move(object));
}

}  // namespace

void add_objects(Scene& scene, const Campaign& campaign,
                 const Spacing& spacing) {
    for (const PanelEntry& each : campaign.panels)
        add(scene,
            {each.rows.name,
             panel_mesh(each.rows, scene.cell, spacing.row_direction,
                        each.rows.tilt),
             true},
            each.optics, each.nir_optics);
    for (const ObjectEntry& each : campaign.objects)
        add(scene, {each.name, mesh_of(each)}, each.optics, each.nir_optics);
}

}  // namespace ideotype
