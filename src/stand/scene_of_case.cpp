// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "campaign/meshes.hpp"
#include "campaign/season_days.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/light/tolerance.hpp"
#include "stand.hpp"

namespace ideotype {

Layers canopy_layers(const Campaign& campaign) {
    constexpr double thickness = 0.25;
    return {thickness,
            static_cast<std::size_t>(std::ceil(campaign.reach / thickness))};
}

namespace {

std::uint32_t first_material(std::size_t component) {
    return static_cast<std::uint32_t>(plant_materials * component);
}

//! Makes a component part of a mixture, in which components share positions.
void mix(Component& component, std::size_t plants) {
    component.ground_per_plant *= static_cast<double>(component.places.size()) /
                                  static_cast<double>(plants);
    component.mixed = plants;
}

//! Sets the positions and azimuths of a component's plants.
void stand_in(Component& component, FieldForm form, const Campaign& campaign,
              const Standing& standing) {
    if (standing.plants > 0) {
        form.spacing.plant *= form.plants;
        form.plants = standing.plants;
        form.spacing.plant /= form.plants;
    }
    if (standing.jitter) {
        form.jitter = *standing.jitter;
        form.variation.across_row.reset();
    }
    if (standing.variation) form.variation = *standing.variation;
    const bool is_mixed = standing.mixed > 0;
    set_places(component, form, is_mixed ? bred_rows(campaign) : standing.rows);
    if (is_mixed) mix(component, static_cast<std::size_t>(standing.mixed));
}

//! Copies the rates of the lowest leaf in a crop file to all lower leaves that
//! the file omits, if leaves assimilate and their rates differ by rank.
void complete_rates(Component& component, std::size_t in_file) {
    if (!component.photosynthesis) return;
    Photosynthesis& photosynthesis = *component.photosynthesis;
    const std::size_t count = component.plant->leaves.size();
    const bool is_by_rank = photosynthesis.profile == CapacityProfile::rank;
    if (in_file == count || (!is_by_rank && photosynthesis.rates.size() == 1))
        return;
    std::vector<LeafRates>& rates = photosynthesis.rates;
    if (is_by_rank)
        rates = rates_of_leaves(photosynthesis, std::vector<double>(in_file));
    if (is_by_rank) photosynthesis.profile = CapacityProfile::none;
    rates.insert(rates.begin(), count - in_file, LeafRates(rates.front()));
}

//! Sets the dry mass of organs that a component builds since the previous
//! stage.
//! @param plant full-grown plant
//! @param before age at the previous stage; below 0: there is none
void set_built_organs(const Growth* growth, const Plant& plant, double before,
                      Component& component) {
    component.built_organs.clear();
    for (const PlantOrgan& organ : list_organs(*component.plant))
        component.built_organs.push_back(organ.mass);
    if (before < 0) return;
    const std::vector<PlantOrgan> then =
        list_organs(growth ? age_plant(*growth, plant, before) : plant);
    for (std::size_t i = 0; i < then.size(); ++i)
        component.built_organs[i] =
            std::max(0., component.built_organs[i] - then[i].mass);
}

//! Sets a component to the plant of a line as it grows at the density of the
//! case, full-grown or at a growth stage.
void set_grown(const Campaign& campaign, const Case& chosen, std::size_t number,
               const Plant& line, Component& component) {
    component.at_reference.reset();
    if (!line.plasticity.responses.empty()) component.at_reference = line;
    const Spacing spacing = spacing_of(campaign, chosen, number);
    component.turn = turn_at(line.plasticity, spacing.plants_per_area());
    component.is_gap_along_row = spacing.plant > spacing.row;
    set_grown_plant(campaign, chosen, number,
                    at_density(campaign, chosen, number, line), component);
}

//! Scales photosynthetic capacity and respiration of leaves to the age of a
//! component (0: the main crop), as its crop's ageing specifies.
void age_leaves(const Campaign& campaign, const Case& chosen,
                std::size_t number, Component& component) {
    const Growth* const growth = growth_of(campaign, number);
    if (!growth || !component.photosynthesis) return;
    const double factor = capacity_factor(
        *growth, chosen.stage
                     ? chosen.stage->ages[number]
                     : find_thermal_time(*growth, campaign.spec.plant.stage));
    if (factor == 1) return;
    for (LeafRates& rates : component.photosynthesis->rates)
        rates = scaled(rates, factor);
}

//! Sets the roots of a growing component, and the fraction of its carbon that
//! its ears later respire.
void set_sinks(const Campaign& campaign, const Case& chosen, std::size_t number,
               Component& component) {
    const Growth* const growth = growth_of(campaign, number);
    if (!growth || !chosen.stage) return;
    component.roots = {
        growth->root_share,
        root_maintenance *
            maintenance_factor(*growth, chosen.stage->ages[number])};
    if (!chosen.stage->ear_shares.empty())
        component.ear_share = chosen.stage->ear_shares[number];
}

//! Returns the optics of the plants of all components in a waveband.
Optics optics_in(const Campaign& campaign, std::size_t band) {
    Optics optics{campaign.spec.plant.crop.optics[band].materials(),
                  campaign.spec.soil_albedo[band]};
    for (const ComponentEntry& each : campaign.components)
        for (const Material& material : each.optics[band].materials())
            optics.materials.push_back(material);
    return optics;
}

//! Returns whether results are reported by row, that is, whether rows differ
//! and each row contains plants of one component.
bool has_rows_apart(const Campaign& campaign) {
    const FieldForm& field = campaign.spec.field;
    return field.boundary == Boundary::periodic && field.rows > 1 &&
           (!field.row_pattern.empty() || !campaign.components.empty()) &&
           std::ranges::none_of(campaign.components, [](const auto& each) {
               return each.standing.mixed > 0;
           });
}

//! Returns the number of dates that provide sun positions, divided among
//! stages.
int sun_dates_of(const Campaign& campaign, const Case& chosen) {
    const LightSpec& light = campaign.spec.light;
    const int dates = light.dates.value_or(0);
    return chosen.stage ? (dates + *light.stages - 1) / *light.stages : dates;
}

//! Assigns a stage light paths in proportion to its share of carbon. Errors of
//! stages are independent, so all stages together meet the tolerance.
void take_share(const Stage& stage, Sampling& sampling) {
    IDEOTYPE_EXPECT(stage.share > 0);
    constexpr double largest = 0.5;
    Accuracy& accuracy = sampling.accuracy;
    accuracy.paths =
        std::max(static_cast<int>(fewest_paths),
                 static_cast<int>(std::lround(accuracy.paths * stage.share)));
    accuracy.tolerance =
        std::min(largest, accuracy.tolerance / std::sqrt(stage.share));
    sampling.randomness.first_randomisation +=
        stage.number * static_cast<std::uint32_t>(accuracy.randomisations);
}

}  // namespace

void set_grown_plant(const Campaign& campaign, const Case& chosen,
                     std::size_t number, const Plant& plant,
                     Component& component) {
    const Growth* const growth = growth_of(campaign, number);
    if (!chosen.stage) {
        Plant aged = plant;
        if (growth)
            age_organs(*growth,
                       find_thermal_time(*growth, campaign.spec.plant.stage),
                       aged);
        return set_plant(component, aged, first_material(number));
    }
    const double age = chosen.stage->ages[number];
    const double before = chosen.stage->ages_before[number];
    set_plant(component, growth ? age_plant(*growth, plant, age) : plant,
              first_material(number));
    component.full_grown = plant;
    const Mesh mesh =
        build_plant(growth ? complete_plant(*growth, plant) : plant,
                    component.tessellation);
    const std::vector<double> areas = face_areas(mesh);
    const std::vector<LeafDates> dates =
        growth ? leaf_dates(*growth) : std::vector<LeafDates>{};
    set_built_organs(growth, plant, before, component);
    component.built.assign(growth ? dates.size() : plant.leaves.size(), 0);
    for (std::size_t f = 0; f < areas.size(); ++f) {
        const std::size_t leaf = mesh.face_group[f];
        if (leaf >= component.built.size()) continue;
        component.built[leaf] +=
            areas[f] * (growth ? visible_share(dates[leaf], age) -
                                     visible_share(dates[leaf], before)
                               : (chosen.stage->number == 0 ? 1 : 0));
    }
}

Scene scene_of(const Campaign& campaign, const Case& chosen) {
    // The periodic cell, and the main crop at its age.
    FieldForm form = campaign.spec.field;
    form.spacing = chosen.spacing;
    Scene scene;
    scene.cell = cell_of(form);
    scene.components = {
        component_of(at_density(campaign, chosen, 0, campaign.crop.baseline),
                     form, campaign.spec.plant.tessellation)};
    Component& bred = scene.components.front();
    bred.photosynthesis = campaign.photosynthesis;
    bred.stomata = campaign.stomata;
    scene.water = campaign.water;
    // The openings between which fluxes are interpolated as soil dries.
    if (scene.water && campaign.spec.soil && chosen.stage)
        scene.water->openings = {0.3, 0.08, 0.04, 0.015};
    if (chosen.stage) {
        set_grown(campaign, chosen, 0, campaign.crop.baseline, bred);
        complete_rates(bred, campaign.crop.baseline.leaves.size());
    }
    age_leaves(campaign, chosen, 0, bred);
    set_sinks(campaign, chosen, 0, bred);
    // The light of the case, and the optics of plants, in each waveband.
    const SeriesIllumination par =
        illuminate(light_of(campaign, chosen), campaign.spec.light.sky,
                   chosen.spacing.row_direction,
                   has_trackers(campaign) ? Skies::each : Skies::shared,
                   sun_dates_of(campaign, chosen));
    for (std::size_t b = 0; b < wavebands.size(); ++b) {
        const Waveband& band = wavebands[b];
        if (campaign.follows[b])
            scene.bands.push_back(
                {band.name, b == 0 ? par : in_band(par, band.light),
                 optics_in(campaign, b),
                 campaign.spec.light.band.value_or(wavebands[0].name) ==
                     band.name});
    }
    // Further components, each in rows or mixed with the main crop.
    if (has_rows_apart(campaign)) scene.cell.row_ground = ground_of_rows(form);
    if (campaign.components.empty()) {
        add_objects(scene, campaign, form.spacing);
        return scene;
    }
    set_places(bred, form, bred_rows(campaign));
    if (bred_plants(campaign) < bred.places.size())
        mix(bred, bred_plants(campaign));
    for (const ComponentEntry& entry : campaign.components) {
        Component& component = scene.components.emplace_back();
        component.name = entry.name;
        if (entry.mesh) {
            component.mesh = *entry.mesh;
            add_surfaces(entry.materials, component.mesh, scene.bands);
            component.photosynthesis = entry.photosynthesis;
            stand_in(component, form, campaign, entry.standing);
            component.variation = {};
            continue;
        }
        component.tessellation = campaign.spec.plant.tessellation;
        component.photosynthesis = entry.photosynthesis;
        component.stomata = entry.stomata;
        set_grown(campaign, chosen, scene.components.size() - 1,
                  entry.crop.baseline, component);
        complete_rates(component, entry.crop.baseline.leaves.size());
        age_leaves(campaign, chosen, scene.components.size() - 1, component);
        set_sinks(campaign, chosen, scene.components.size() - 1, component);
        stand_in(component, form, campaign, entry.standing);
    }
    add_objects(scene, campaign, form.spacing);
    return scene;
}

Details details_of(const Campaign& campaign) {
    return {.form = asks_for(campaign, is_of_form),
            .soil = campaign.spec.soil.has_value(),
            .grain = fills_grain(campaign),
            .prices = campaign.spec.prices.has_value(),
            .lines = campaign.spec.feasibility.known_lines()};
}

CanopyRequest request_of(Sampling sampling, const Campaign& campaign,
                         const Case& chosen, Scene scene,
                         const Plants& plants) {
    IDEOTYPE_EXPECT(!plants.empty() &&
                    plants.size() <= scene.components.size());
    for (std::size_t i = 0; i < plants.size(); ++i)
        if (i == 0 || !campaign.components.at(i - 1).free.empty())
            set_grown(campaign, chosen, i, plants[i], scene.components.at(i));
    if (chosen.stage) take_share(*chosen.stage, sampling);
    return {std::move(scene), canopy_layers(campaign), sampling.accuracy,
            sampling.randomness, details_of(campaign)};
}

}  // namespace ideotype
