// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "field_light.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "randomisations.hpp"

namespace ideotype {

namespace {

//! Smallest number of randomisations per field that assimilate() accepts.
constexpr int fewest_in_field = 4;

//! Returns whether the fields of a scene are random and may differ.
bool are_drawn(const Scene& scene) {
    return std::any_of(
        scene.components.begin(), scene.components.end(),
        [](const Component& each) { return each.plant || each.jitter > 0; });
}

//! Returns the leaf area index of each group of a scene for plants that do not
//! deviate from their line.
std::vector<double> leaf_area_of_lines(const Scene& scene, std::size_t groups) {
    std::vector<double> index;
    index.reserve(groups);
    for (const Component& each : scene.components) {
        const std::vector<double> of_faces = face_areas(each.mesh);
        const std::size_t first = index.size();
        index.resize(first + each.mesh.groups.size());
        for (std::size_t f = 0; f < of_faces.size(); ++f)
            if (each.mesh.groups[each.mesh.face_group[f]].id.is_leaf())
                index[first + each.mesh.face_group[f]] +=
                    of_faces[f] / each.ground_per_plant;
    }
    index.resize(groups);
    return index;
}

Pieces pieces_of_line(const Component& component,
                      const CanopyRequest& request) {
    const std::size_t per_blade = request.details.pieces;
    if (!component.photosynthesis) return uncut(component.mesh);
    if (component.plant) return cut_leaves(component.mesh, per_blade);
    return cut_coarse_leaves(component.mesh, component.plants(),
                             request.accuracy.tolerance, per_blade);
}

}  // namespace

Plan::Plan(const CanopyRequest& request)
    : accuracy(request.accuracy), randomness_(request.randomness) {
    IDEOTYPE_EXPECT(accuracy.paths > 0 && accuracy.randomisations > 0);
    IDEOTYPE_EXPECT(accuracy.tolerance >= 0);
    if (are_drawn(request.scene))
        fields = std::clamp(accuracy.fields, 1, accuracy.randomisations);
    accuracy.randomisations /= fields;
    accuracy.tolerance *= std::sqrt(fields);
    if (request.scene.assimilates() && !request.details.exact &&
        accuracy.randomisations < fewest_in_field) {
        accuracy.paths =
            accuracy.paths * accuracy.randomisations / fewest_in_field;
        accuracy.randomisations = fewest_in_field;
    }
    is_one_of_many = fields > 1 && accuracy.randomisations > 1;
    // Each source needs at least one path.
    accuracy.paths =
        std::max(accuracy.paths,
                 static_cast<int>(request.scene.light().light.sources.size()));
}

Randomness Plan::of_plants(int field) const {
    if (!randomness_.has_common_fields) return of_field(field, 1);
    return {randomness_.seed, 0, static_cast<std::uint32_t>(field)};
}

Randomness Plan::of_field(int field, int times) const {
    IDEOTYPE_EXPECT(field >= 0 && field < fields);
    Randomness numbers = randomness_;
    numbers.first_randomisation =
        (numbers.first_randomisation + static_cast<std::uint32_t>(field)) *
        static_cast<std::uint32_t>(times);
    return numbers;
}

Lines::Lines(const Scene& scene, const CanopyRequest& request)
    : are_cut((scene.assimilates() && !request.details.exact) ||
              !scene.cell.row_ground.empty()),
      groups(groups_of(scene)) {
    if (scene.varies())
        leaf_area_index = leaf_area_of_lines(scene, groups.size());
    if (!are_cut) return;
    for (const Component& each : scene.components) {
        pieces.push_back(pieces_of_line(each, request));
        if (scene.water) {
            pieces.back().width = local_widths(pieces.back());
            for (const glm::dvec3& vertex : each.mesh.vertices)
                height = std::max(height, vertex.z);
        }
        meshes.push_back(std::move(pieces.back().mesh));
    }
}

Bands bands_of(const Scene& scene) {
    Bands bands = scene.bands;
    if (!scene.water || !scene.water->has_leaf_temperature) return bands;
    const auto found = std::ranges::find(bands, nir, &Band::name);
    if (found == bands.end())
        throw Error(
            "leaves have an energy balance, but the scene has no near "
            "infrared; add a band \"nir\"");
    found->is_by_piece = true;
    // Near infrared only heats leaves: a tenth of the paths is sufficient.
    if (!found->is_bounded) found->path_share = 0.1;
    Band sky{longwave, scene.light(), {}, false, true};
    sky.optics.materials.resize(bands.front().optics.materials.size());
    sky.optics.soil_albedo = 0;
    bands.push_back(std::move(sky));
    return bands;
}

void FieldLight::append(FieldLight more) {
    IDEOTYPE_EXPECT(light.empty() || light.size() == more.light.size());
    light.resize(more.light.size());
    rows.resize(more.rows.size());
    for (std::size_t b = 0; b < light.size(); ++b) {
        ideotype::append(light[b], std::move(more.light[b]));
        ideotype::append(rows[b], std::move(more.rows[b]));
    }
    FluxTallies& tallies = fluxes.tallies;
    tallies.resize(more.fluxes.tallies.size());
    for (std::size_t k = 0; k < tallies.size(); ++k)
        ideotype::append(tallies[k], std::move(more.fluxes.tallies[k]));
    for (std::size_t l = 0; l < fluxes.closed.size(); ++l)
        for (std::size_t k = 0; k < leaf_fluxes; ++k)
            add(fluxes.closed[l][k], more.fluxes.closed[l][k]);
    add(leaf_area_of_layers, more.leaf_area_of_layers);
    ideotype::append(sunlit, std::move(more.sunlit));
    ideotype::append(hit_by_sun, std::move(more.hit_by_sun));
    ideotype::append(light_classes, std::move(more.light_classes));
    add(areas, more.areas);
    ideotype::append(leaf_area, std::move(more.leaf_area));
    add(leaf_area_index, more.leaf_area_index);
    add(areas_of_groups, more.areas_of_groups);
    add(areas_of_rows, more.areas_of_rows);
    paths += more.paths;
    is_capped |= more.is_capped;
    seconds += more.seconds;
    fields += more.fields;
}

}  // namespace ideotype
