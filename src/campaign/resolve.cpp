// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <span>

#include "campaign.hpp"
#include "campaign/checks/checks.hpp"
#include "campaign/leaves.hpp"
#include "campaign/meshes.hpp"
#include "ideotype/core/contract.hpp"
#include "search/sensitivity_design.hpp"
#include "spec/varied_keys.hpp"

namespace ideotype {

namespace {

//! Returns the largest height that an upright leaf could reach [m] at any
//! density of the campaign, in the baseline or with all traits at their upper
//! bounds.
double reach_of(const Spec& spec, const Crop& crop,
                const std::vector<Range>& bounds,
                const PlantVariation& variation) {
    std::vector<double> upper;
    for (const Range& range : bounds) upper.push_back(range.upper);
    const Plant largest = upper.empty() ? crop.baseline : grow(crop, upper);
    double top = 0;
    const auto reach = [&](const Plant& plant) {
        for (const Leaf& leaf : plant.leaves)
            top = std::max(top, furthest(plant, leaf, variation));
    };
    for (const Plant* plant : {&crop.baseline, &largest}) {
        reach(*plant);
        if (plant->plasticity.responses.empty()) continue;
        for (const NamedSpacing& each : spec.spacings)
            reach(respond(*plant, each.value.plants_per_area()));
    }
    return top;
}

//! Makes a crop, without responses to density if the campaign ignores them.
Crop crop_in(const Spec& spec, const CropSpec& of) {
    Crop crop = crop_of(of);
    if (!spec.plant.is_plastic) {
        crop.baseline.plasticity.responses.clear();
        crop.baseline.plasticity.turn = 0;
    }
    return crop;
}

std::vector<Range> all_bounds(const CropSpec& spec, const Crop& crop) {
    const std::vector<double> baseline = baseline_numbers(crop);
    const std::vector<TraitNumber> numbers = trait_numbers(crop);
    std::vector<Range> bounds;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        bounds.push_back(bounds_of(spec, numbers[i].trait, baseline[i]));
    return bounds;
}

ComponentEntry to_component(const Spec& campaign, const ComponentSpec& spec) {
    ComponentEntry component;
    component.name = spec.name;
    Standing& standing = component.standing;
    standing = {{},         spec.mixed,  spec.plants,
                spec.later, spec.jitter, spec.variation};
    for (const double row : spec.rows)
        standing.rows.push_back(static_cast<int>(row) - 1);
    if (spec.has_mesh()) {
        component.mesh = mesh_of(spec.mesh);
        component.materials = spec.mesh.materials;
        return component;
    }
    component.crop = crop_in(campaign, spec.crop);
    component.bounds = all_bounds(spec.crop, component.crop);
    component.free = spec.free;
    component.optics = spec.crop.optics;
    return component;
}

std::optional<Photosynthesis> photosynthesis_of(const ComponentSpec& spec) {
    if (!spec.has_mesh()) return to_photosynthesis(spec.crop.photosynthesis);
    if (!spec.mesh.photosynthesis) return std::nullopt;
    return to_photosynthesis(*spec.mesh.photosynthesis);
}

//! Sets the plants, bounds and photosynthesis of the stand.
void resolve_stand(Campaign& campaign) {
    const Spec& spec = campaign.spec;
    const CropSpec& crop = spec.plant.crop;
    const PlantVariation& variation = spec.field.variation;
    campaign.crop = crop_in(spec, crop);
    campaign.bounds = all_bounds(crop, campaign.crop);
    campaign.reach = reach_of(spec, campaign.crop, campaign.bounds, variation);
    campaign.follows = crop.follows;
    campaign.sampling = {*spec.light.paths, spec.light.randomisations,
                         *spec.light.tolerance, spec.light.fields};
    for (const ComponentSpec& component : spec.components) {
        const ComponentEntry& added =
            campaign.components.emplace_back(to_component(spec, component));
        campaign.reach = std::max(
            campaign.reach,
            added.mesh
                ? heights_of(*added.mesh).upper
                : reach_of(
                      spec, added.crop,
                      added.free.empty() ? std::vector<Range>{} : added.bounds,
                      added.standing.variation.value_or(variation)));
    }
    if (!spec.assimilates) return;
    campaign.photosynthesis = to_photosynthesis(crop.photosynthesis);
    campaign.leaves = stated_leaves(spec);
    for (std::size_t i = 0; i < spec.components.size(); ++i)
        campaign.components[i].photosynthesis =
            photosynthesis_of(spec.components[i]);
    if (!spec.water) return;
    campaign.water = spec.water->rules;
    campaign.stomata = to_stomata(*spec.water, *campaign.photosynthesis);
    for (ComponentEntry& each : campaign.components)
        each.stomata = to_stomata(*spec.water, *each.photosynthesis);
}

//! Returns the default population for the case with the most free genes.
int usual_population_of(const Campaign& campaign) {
    std::size_t largest = 1;
    Case chosen;
    for (const NamedTraits& set : campaign.spec.trait_sets) {
        chosen.traits = set.value;
        largest = std::max(largest, count_free(gene_space(campaign, chosen)));
    }
    return usual_population(campaign.search.optimizer,
                            largest + campaign.varied.keys.size());
}

//! Sets the search settings for a sensitivity study. It ends only with the last
//! row of its design.
void plan_study(Campaign& campaign) {
    SensitivitySpec& spec = campaign.spec.sensitivity;
    constexpr int few = 64;
    SensitivitySettings design{spec.method, SensitivitySettings{}.samples,
                               spec.levels, spec.groups};
    if (spec.method == SensitivityMethod::morris) design.samples = few;
    design.samples = spec.samples.value_or(design.samples);
    spec.samples = design.samples;
    campaign.varied = {spec.has_traits, spec.keys};
    campaign.search.population = 0;
    Case chosen;
    for (const NamedTraits& set : campaign.spec.trait_sets) {
        chosen.traits = set.value;
        campaign.search.population =
            std::max(campaign.search.population,
                     generation_size(design, search_genes(campaign, chosen)));
    }
    campaign.stop = {.generations = count_generations(design)};
    campaign.search.design = design;
    campaign.has_light_by_row = true;
}

//! Sets the search settings, including defaults.
void plan_search(Campaign& campaign) {
    Spec& spec = campaign.spec;
    SearchSettings& search = campaign.search;
    campaign.stop = spec.stop;
    campaign.varied = {true, spec.search.keys};
    search = {.optimizer = spec.search.optimizer_or_usual(),
              .population = spec.search.population_or_usual(),
              .streams = spec.search.streams,
              .ga = spec.search.ga,
              .start = spec.search.start,
              .axes = spec.search.axes,
              .reference = spec.search.reference};
    if (spec.is_study) campaign.varied = {};
    if (uses_cma_es(search.optimizer) && !spec.search.population)
        search.population = usual_population_of(campaign);
    const int usual_candidates =
        search.optimizer == OptimizerKind::atlas
            ? static_cast<int>(count_cells(search.axes))
            : FinalRule{}.candidates;
    campaign.final_rule = {spec.final.candidates.value_or(usual_candidates),
                           {spec.final.paths, spec.final.randomisations}};
    if (spec.is_study) plan_study(campaign);
    spec.search.optimizer = search.optimizer;
    spec.search.population = search.population;
    spec.stop = campaign.stop;
    spec.final.candidates = campaign.final_rule.candidates;
    // search.start describes only a plant. Varied keys start from their values
    // in the campaign.
    if (!search.start.empty())
        for (const KeyFactor& each : campaign.varied.keys)
            search.start.push_back(each.number);
}

}  // namespace

Campaign resolve(const Spec& spec) {
    Campaign campaign;
    campaign.spec = spec;
    std::erase_if(campaign.spec.constraints.traits,
                  [](const TraitConstraint& x) { return !constrains(x); });
    resolve_stand(campaign);
    // Layers are the same for all values of varied keys.
    for (const KeyFactor& factor :
         spec.is_study ? spec.sensitivity.keys : spec.search.keys)
        for (const double number : tried_numbers(factor)) {
            Campaign varied;
            varied.spec = spec;
            set_keys(varied.spec, {factor}, std::array{number});
            resolve_stand(varied);
            campaign.reach = std::max(campaign.reach, varied.reach);
        }
    plan_search(campaign);
    return campaign;
}

Campaign with_keys(const Campaign& campaign, const std::vector<KeyFactor>& keys,
                   std::span<const double> numbers) {
    Campaign varied;
    varied.spec = campaign.spec;
    varied.search = campaign.search;
    varied.varied = campaign.varied;
    varied.has_light_by_row = campaign.has_light_by_row;
    varied.stop = campaign.stop;
    varied.final_rule = campaign.final_rule;
    set_keys(varied.spec, keys, numbers);
    const Problems problems(campaign.spec.name);
    check_variable(varied.spec, problems);
    problems.throw_if_any();
    resolve_stand(varied);
    varied.reach = campaign.reach;
    return varied;
}

bool draws_change_light(const Spec& spec) {
    Spec varied = spec;
    const std::vector<VariableKey> keys = variable_keys(varied);
    return std::ranges::any_of(spec.draws, [&](const NamedDraw& each) {
        return std::ranges::any_of(each.value.keys, [&](const auto& key) {
            const auto variable =
                std::ranges::find(keys, key, &VariableKey::name);
            IDEOTYPE_EXPECT(variable != keys.end());
            return !variable->keeps_light;
        });
    });
}

Campaign at_keys(const Campaign& campaign, Genome& genome) {
    const std::vector<KeyFactor>& keys = campaign.varied.keys;
    const std::size_t plain = count_genes(campaign);
    if (keys.empty() || genome.size() != plain + keys.size()) return campaign;
    const Genome numbers(genome.begin() + static_cast<std::ptrdiff_t>(plain),
                         genome.end());
    genome.resize(plain);
    return with_keys(campaign, keys, numbers);
}

}  // namespace ideotype
