// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "campaign/cases.hpp"
#include "checks.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/light/tolerance.hpp"
#include "spec/spec.hpp"

namespace ideotype {

namespace {

//! Returns the number of leaf pieces for which assimilation is computed.
double pieces_of(const Crop& crop, std::size_t plants) {
    return static_cast<double>(
        plants * crop.baseline.leaves.size() *
        static_cast<std::size_t>(crop.baseline.blade.leaflets) *
        pieces_of_blade);
}

//! Returns the number of plants of a component of a campaign.
std::size_t plants_of(const Standing& standing, const FieldForm& field) {
    if (standing.mixed > 0) return static_cast<std::size_t>(standing.mixed);
    return standing.rows.size() * static_cast<std::size_t>(standing.plants > 0
                                                               ? standing.plants
                                                               : field.plants);
}

//! Returns whether any objective depends on the light response of leaves.
bool depends_on_response(const Campaign& campaign) {
    return asks_for_assimilation(campaign.spec) ||
           asks_for(campaign, is_of_water) ||
           (campaign.photosynthesis &&
            asks_for(campaign, is_of_two_components));
}

}  // namespace

void check_paths(const Campaign& campaign, const Problems& problems) {
    if (!depends_on_response(campaign)) return;
    double pieces = campaign.photosynthesis
                        ? pieces_of(campaign.crop, bred_plants(campaign))
                        : 0;
    for (const ComponentEntry& component : campaign.components)
        if (component.photosynthesis)
            pieces +=
                component.mesh
                    ? static_cast<double>(
                          component.mesh->faces.size() *
                          plants_of(component.standing, campaign.spec.field))
                    : pieces_of(component.crop, plants_of(component.standing,
                                                          campaign.spec.field));
    // Paths are divided among fields and stages.
    const Accuracy& light = campaign.sampling;
    const double scenes =
        light.fields * (campaign.spec.light.stages.value_or(1));
    // Count each path as one hit of diffuse light, which is an upper bound.
    const double hits =
        static_cast<double>(light.all_paths()) / (scenes * pieces);
    problems.doubt(
        {"paths"}, pieces > 0 && hits < hits_of_piece,
        "light.paths is {} (with {} randomisations these are {:.2g} paths per "
        "piece of leaf, too few for this objective: below {}, products of "
        "light estimates are noisier than the light itself); use {:.0f} or "
        "more, or light.tolerance alone",
        light.paths, light.randomisations, hits, hits_of_piece,
        std::ceil(hits_of_piece * pieces * scenes / light.randomisations));
}

}  // namespace ideotype
