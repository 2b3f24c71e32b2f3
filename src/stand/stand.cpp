// SPDX-License-Identifier: Apache-2.0
#include "stand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "campaign/stages.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/hash.hpp"
#include "ideotype/light/tolerance.hpp"
#include "placed_objects.hpp"

namespace ideotype {

double final_effort(const Campaign& campaign) {
    const auto paths = [](const Accuracy& accuracy) {
        return static_cast<double>(accuracy.all_paths());
    };
    const Accuracy& final = campaign.final_rule.sampling;
    // With a tolerance an evaluation may need the least that there is.
    Accuracy usual = campaign.sampling;
    if (usual.tolerance > 0) usual.paths = std::min(usual.paths, fewest_paths);
    return std::max<double>(paths(final) / paths(usual), final.randomisations);
}

Layers canopy_layers(const Campaign& campaign) {
    constexpr double thickness = 0.25;
    return {thickness,
            static_cast<std::size_t>(std::ceil(campaign.reach / thickness))};
}

namespace {

//! The place of a component's first material among those of the scene.
std::uint32_t first_material(std::size_t component) {
    return static_cast<std::uint32_t>(plant_materials * component);
}

//! Makes a component one of a mixture that shares its places.
void mix(Component& component, std::size_t plants) {
    component.ground_per_plant *= static_cast<double>(component.places.size()) /
                                  static_cast<double>(plants);
    component.mixed = plants;
}

//! Sets where the plants of a component stand, and how they turn.
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

//! Gives lower leaves that a crop file leaves out the rates of its lowest one,
//! where leaves differ by rank and assimilate.
//! @param own leaves of the crop file
void complete_rates(Component& component, std::size_t own) {
    if (!component.photosynthesis) return;
    Photosynthesis& photosynthesis = *component.photosynthesis;
    const std::size_t all = component.plant->leaves.size();
    const bool is_by_rank = photosynthesis.profile == CapacityProfile::rank;
    if (own == all || (!is_by_rank && photosynthesis.rates.size() == 1)) return;
    std::vector<LeafRates>& rates = photosynthesis.rates;
    if (is_by_rank)
        rates = rates_of_leaves(photosynthesis, std::vector<double>(own));
    if (is_by_rank) photosynthesis.profile = CapacityProfile::none;
    rates.insert(rates.begin(), all - own, LeafRates(rates.front()));
}

//! Makes a component that of a full-grown plant, or of one at the age that it
//! has at a stage.
void set_grown(const Campaign& campaign, const Case& in, std::size_t number,
               const Plant& plant, Component& component) {
    if (!in.stage) return set_plant(component, plant, first_material(number));
    const Growth* const growth = growth_of(campaign, number);
    const double age = in.stage->ages[number];
    const double before = in.stage->ages_before[number];
    set_plant(component, growth ? plant_at(*growth, plant, age) : plant,
              first_material(number));
    component.full_grown = plant;
    const Mesh mesh =
        build_plant(growth ? complete_plant(*growth, plant) : plant,
                    component.tessellation);
    const std::vector<double> areas = face_areas(mesh);
    const std::vector<LeafDates> dates =
        growth ? leaf_dates(*growth) : std::vector<LeafDates>{};
    component.built.assign(growth ? dates.size() : plant.leaves.size(), 0);
    for (std::size_t f = 0; f < areas.size(); ++f) {
        const std::size_t leaf = mesh.face_group[f];
        if (leaf >= component.built.size()) continue;
        component.built[leaf] +=
            areas[f] * (growth ? visible_share(dates[leaf], age) -
                                     visible_share(dates[leaf], before)
                               : (in.stage->number == 0 ? 1 : 0));
    }
}

//! Tells whether figures of single rows are wanted: rows are not alike, and
//! each has plants of one component.
bool has_rows_apart(const Campaign& campaign) {
    const FieldForm& field = campaign.field;
    return field.boundary == Boundary::periodic && field.rows > 1 &&
           (!field.row_pattern.empty() || !campaign.components.empty()) &&
           std::none_of(campaign.components.begin(), campaign.components.end(),
                        [](const ComponentEntry& each) {
                            return each.standing.mixed > 0;
                        });
}

//! Returns how many dates have suns of their own: stages share them out.
int sun_dates_of(const Campaign& campaign, const Case& chosen) {
    return chosen.stage
               ? (campaign.sun_dates + campaign.stages - 1) / campaign.stages
               : campaign.sun_dates;
}

//! Gives a stage its part of the paths, by what it carries: errors of stages
//! are independent, so that all of them together have the tolerance.
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

Scene scene_of(const Campaign& campaign, const Case& chosen) {
    FieldForm form = campaign.field;
    form.spacing = chosen.spacing;
    Scene scene;
    scene.cell = cell_of(form);
    scene.components = {
        component_of(campaign.crop.baseline, form, campaign.tessellation)};
    Component& bred = scene.components.front();
    bred.photosynthesis = campaign.photosynthesis;
    bred.stomata = campaign.stomata;
    scene.water = campaign.water;
    if (chosen.stage) {
        set_grown(campaign, chosen, 0, campaign.crop.baseline, bred);
        complete_rates(bred, campaign.crop.baseline.leaves.size());
    }
    scene.bands = {
        {"par",
         illuminate(light_of(campaign, chosen), campaign.sky_model,
                    chosen.spacing.row_direction,
                    has_trackers(campaign) ? Skies::each : Skies::shared,
                    sun_dates_of(campaign, chosen)),
         {campaign.optics.materials(), campaign.soil_albedo}}};
    if (campaign.has_nir) {
        scene.bands.push_back(
            {"nir",
             in_band(scene.light(), &TimeStep::nir),
             {campaign.nir_optics.materials(), campaign.nir_soil_albedo}});
        const bool is_nir = campaign.bounded_band == BoundedBand::nir;
        scene.bands[0].is_bounded = !is_nir;
        scene.bands[1].is_bounded = is_nir;
    }
    if (has_rows_apart(campaign)) scene.cell.row_ground = ground_of_rows(form);
    if (campaign.components.empty()) {
        add_objects(scene, campaign, form.spacing);
        return scene;
    }
    set_places(bred, form, bred_rows(campaign));
    if (bred_plants(campaign) < bred.places.size())
        mix(bred, bred_plants(campaign));
    for (const ComponentEntry& each : campaign.components) {
        Component& component = scene.components.emplace_back();
        component.name = each.name;
        component.tessellation = campaign.tessellation;
        component.photosynthesis = each.photosynthesis;
        component.stomata = each.stomata;
        set_grown(campaign, chosen, scene.components.size() - 1,
                  each.crop.baseline, component);
        complete_rates(component, each.crop.baseline.leaves.size());
        stand_in(component, form, campaign, each.standing);
        for (Band& band : scene.bands)
            for (const Material& material :
                 (band.name == "nir" ? each.nir_optics : each.optics)
                     .materials())
                band.optics.materials.push_back(material);
    }
    add_objects(scene, campaign, form.spacing);
    return scene;
}

Details details_of(const Campaign& campaign) {
    return {.lines = campaign.feasibility.lines};
}

CanopyRequest request_of(Sampling sampling, const Campaign& campaign,
                         const Case& in, Scene scene, const Plants& plants) {
    IDEOTYPE_EXPECT(!plants.empty() &&
                    plants.size() <= scene.components.size());
    for (std::size_t i = 0; i < plants.size(); ++i)
        if (i == 0 || !campaign.components.at(i - 1).free.empty())
            set_grown(campaign, in, i, plants[i], scene.components.at(i));
    if (in.stage) take_share(*in.stage, sampling);
    return {std::move(scene), canopy_layers(campaign), sampling.accuracy,
            sampling.randomness, details_of(campaign)};
}

OutcomeSchema outcome_schema(const Campaign& campaign, const Case& chosen,
                             const Accuracy& accuracy) {
    OutcomeSchema schema;
    schema.measured = AcrossScenarios(campaign, chosen).measured();
    schema.randomisations = static_cast<std::size_t>(accuracy.repetitions());
    for (const ObjectiveEntry& objective : objectives_of(campaign))
        schema.objectives.push_back({objective.name,
                                     unit_of(campaign, objective.quantity),
                                     objective.sense});
    return schema;
}

namespace {

//! Returns the leaf area index that constraints are about.
double constrained_lai(const Campaign& campaign, const Plant& plant,
                       const CanopyReport& report) {
    const ComponentReport& bred = report.components.front();
    return campaign.field.variation.is_any() || report.grows
               ? lai_of_line(build_plant(plant, campaign.tessellation),
                             bred.ground_per_plant)
               : bred.lai;
}

}  // namespace

double lai_of_line(const Mesh& plant, double ground_per_plant) {
    IDEOTYPE_EXPECT(ground_per_plant > 0);
    return plant_area(plant).leaves / ground_per_plant;
}

Randomised measure_number(const Campaign& campaign, const std::string& name,
                          const CanopyReport& report) {
    const std::vector<ObjectiveEntry> all = objectives_of(campaign);
    const auto objective =
        std::find_if(all.begin(), all.end(),
                     [&](const ObjectiveEntry& x) { return x.name == name; });
    if (objective != all.end() && objective->component)
        return measure_parts(objective->quantity, report)
            .at(*objective->component);
    const std::vector<double> weights = component_weights(campaign);
    return objective != all.end() && !weights.empty()
               ? weighted_sum(measure_parts(name, report), weights)
               : measure_objective(name, report);
}

Estimate land_equivalent_ratio(const Campaign& campaign,
                               const CanopyReport& report) {
    IDEOTYPE_EXPECT(!campaign.sole.empty());
    const std::string quantity = objectives_of(campaign).front().quantity;
    Estimate ratio = measure_number(campaign, quantity, report).estimate;
    const std::vector<Randomised> parts = measure_parts(quantity, report);
    for (std::size_t c = 0; c < campaign.sole_errors.size(); ++c)
        ratio.standard_error =
            std::hypot(ratio.standard_error,
                       parts[c].estimate.mean / campaign.sole[c] *
                           campaign.sole_errors[c] / campaign.sole[c]);
    return ratio;
}

Outcome to_outcome(const Campaign& campaign, const Plant& plant,
                   const CanopyReport& report) {
    Outcome outcome;
    outcome.status = Status::done;
    for (const ObjectiveEntry& objective : objectives_of(campaign)) {
        const auto [mean, values] =
            measure_number(campaign, objective.name, report);
        outcome.objectives.push_back(mean);
        outcome.randomisations.insert(outcome.randomisations.end(),
                                      values.begin(), values.end());
    }
    outcome.violation =
        violation(campaign.constraints, campaign.crop.traits, plant,
                  constrained_lai(campaign, plant, report));
    if (const double limit = campaign.feasibility.limit;
        report.lines && limit > 0)
        outcome.violation += std::max(0.0, report.lines->from_mean / limit - 1);
    outcome.quantities = measure(report);
    return outcome;
}

Stand::Stand(const Campaign& campaign, const Case& chosen)
    : campaign_(campaign),
      cases_(evaluated_cases(chosen)),
      across_(campaign, chosen),
      schema_(outcome_schema(campaign, chosen, campaign.sampling)),
      final_schema_(schema_) {
    final_schema_.randomisations =
        static_cast<std::size_t>(campaign.final_rule.sampling.randomisations);
}

void Stand::prepare() {
    if (!scenes_.empty()) return;
    for (const Case& each : cases_)
        scenes_.push_back(scene_of(campaign_, each));
}

template <class Take>
void Stand::evaluate_each(const Plants& plants, const Sampling& sampling,
                          const Device& device, Take take) {
    prepare();
    for (std::size_t i = 0; i < scenes_.size(); ++i)
        take(ideotype::evaluate(
            request_of(sampling, campaign_, cases_[i], scenes_[i], plants),
            device));
}

Outcome Stand::evaluate(const Plants& plants, const Sampling& sampling,
                        const Device& device) {
    std::vector<Outcome> outcomes;
    evaluate_each(plants, sampling, device, [&](const CanopyReport& report) {
        outcomes.push_back(to_outcome(campaign_, plants.front(), report));
    });
    Outcome outcome = across_.combine(outcomes);
    IDEOTYPE_ENSURE(outcome.quantities.size() == schema_.measured.size());
    if (campaign_.water_limit > 0)
        outcome.violation += std::max(
            0., outcome.quantities[schema_.measured.offset("water_use")].mean /
                        campaign_.water_limit -
                    1);
    return outcome;
}

RandomisedOutcome Stand::evaluate_by_randomisation(const Plants& plants,
                                                   const Sampling& sampling,
                                                   const Device& device) {
    std::vector<Outcome> outcomes;
    std::vector<std::vector<Outcome>> apart;  // [randomisation, case]
    evaluate_each(plants, sampling, device, [&](const CanopyReport& report) {
        outcomes.push_back(to_outcome(campaign_, plants.front(), report));
        const std::vector<Randomised> all = measure_by_randomisation(report);
        apart.resize(report.randomisations());
        for (std::size_t r = 0; r < apart.size(); ++r) {
            Outcome& one = apart[r].emplace_back(outcomes.back());
            for (std::size_t q = 0; q < all.size(); ++q) {
                const std::vector<double>& values = all[q].by_randomisation;
                one.quantities[q] = {
                    values.empty() ? std::numeric_limits<double>::quiet_NaN()
                                   : values.at(r),
                    0};
            }
        }
    });
    RandomisedOutcome found{across_.combine(outcomes), {}};
    for (const std::vector<Outcome>& each : apart) {
        std::vector<double>& values = found.quantities.emplace_back();
        for (const Estimate& x : across_.combine(each).quantities)
            values.push_back(x.mean);
    }
    return found;
}

}  // namespace ideotype
