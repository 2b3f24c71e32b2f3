// SPDX-License-Identifier: Apache-2.0
#include "campaign.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "campaign/checks/checks.hpp"
#include "campaign/reading/files.hpp"
#include "campaign/reading/reader.hpp"
#include "campaign/schema/leaf_tables.hpp"
#include "campaign/schema/schema.hpp"
#include "draft.hpp"
#include "ideotype/core/hash.hpp"
#include "problems.hpp"
#include "search/sensitivity_design.hpp"

namespace ideotype {

namespace {

//! Returns the height of the highest leaf with all numbers at their upper
//! bounds, or of the highest leaf of the baseline, if it stood upright [m].
double reach_of(const Crop& crop, const std::vector<Range>& bounds,
                const PlantVariation& variation) {
    std::vector<double> most;
    for (const Range& range : bounds) most.push_back(range.upper);
    const Plant largest = most.empty() ? crop.baseline : grow(crop, most);
    double top = 0;
    for (const Plant* plant : {&crop.baseline, &largest})
        for (const Leaf& leaf : plant->leaves)
            top = std::max(top, furthest(*plant, leaf, variation));
    return top;
}

//! Returns the usual population for the most free genes of any case.
int usual_population_of(const Campaign& campaign) {
    std::size_t most = 1;
    Case chosen;
    for (const Named<TraitSet>& set : campaign.trait_sets) {
        chosen.traits = set.value;
        most = std::max(most, count_free(gene_space(campaign, chosen)));
    }
    return usual_population(campaign.search.optimizer,
                            most + campaign.varied.keys.size());
}

std::vector<Range> all_bounds(const Draft& draft, const Crop& crop) {
    const std::vector<double> baseline = baseline_numbers(crop);
    const std::vector<TraitNumber> numbers = trait_numbers(crop);
    std::vector<Range> bounds;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        bounds.push_back(bounds_of(draft, numbers[i].trait, baseline[i]));
    return bounds;
}

ComponentEntry to_neighbour(const Draft& draft, bool assimilates) {
    const Campaign& own = draft.campaign;
    ComponentEntry component;
    component.name = own.name;
    component.standing = draft.standing;
    component.crop = crop_of(draft);
    for (const double row : draft.rows)
        component.standing.rows.push_back(static_cast<int>(row) - 1);
    if (draft.has_variation) component.standing.variation = own.field.variation;
    component.bounds = all_bounds(draft, component.crop);
    component.free = own.trait_sets.front().value;
    component.optics = own.optics;
    if (assimilates)
        component.photosynthesis = to_photosynthesis(draft.photosynthesis);
    return component;
}

//! Plans a sensitivity study, which ends only with the last row of its design.
void plan_study(Draft& draft, Campaign& campaign) {
    SensitivitySettings& design = draft.design;
    constexpr int few = 64;
    if (design.method == SensitivityMethod::morris && !draft.has_samples)
        design.samples = few;
    campaign.varied = draft.varied;
    campaign.search.population = 0;
    Case chosen;
    for (const Named<TraitSet>& set : campaign.trait_sets) {
        chosen.traits = set.value;
        campaign.search.population =
            std::max(campaign.search.population,
                     generation_size(design, search_genes(campaign, chosen)));
    }
    campaign.stop = {.generations = generations_of(design),
                     .failed_fraction = campaign.stop.failed_fraction};
    campaign.search.design = design;
    campaign.has_light_by_row = true;
}

Campaign complete(Draft& draft, const std::string& source) {
    Campaign campaign = draft.campaign;
    const PlantVariation& variation = campaign.field.variation;
    campaign.crop = crop_of(draft);
    campaign.bounds = all_bounds(draft, campaign.crop);
    campaign.reach = reach_of(campaign.crop, campaign.bounds, variation);
    for (const std::shared_ptr<Draft>& each : draft.components) {
        const ComponentEntry& added = campaign.components.emplace_back(
            to_neighbour(*each, draft.has_photosynthesis));
        campaign.reach = std::max(
            campaign.reach,
            reach_of(added.crop,
                     added.free.empty() ? std::vector<Range>{} : added.bounds,
                     added.standing.variation.value_or(variation)));
    }
    if (!draft.is_study) campaign.varied.keys = draft.searched;
    if (uses_cma_es(campaign.search) && !draft.has_population)
        campaign.search.population = usual_population_of(campaign);
    if (campaign.search.optimizer == OptimizerKind::atlas &&
        !draft.has_finalists)
        campaign.final_rule.candidates =
            static_cast<int>(count_cells(campaign.search.axes));
    if (draft.is_study) plan_study(draft, campaign);
    draft.campaign.search = campaign.search;
    draft.campaign.stop = campaign.stop;
    draft.campaign.final_rule = campaign.final_rule;
    // A start is a plant; keys start from their values in the campaign.
    if (!campaign.search.start.empty())
        for (const KeyFactor& each : campaign.varied.keys)
            campaign.search.start.push_back(each.value);
    if (draft.has_photosynthesis)
        campaign.photosynthesis = to_photosynthesis(draft.photosynthesis);
    campaign.leaves = stated_leaves(draft);
    if (draft.has_water) {
        campaign.water = draft.water.rules;
        campaign.water_limit = draft.water.limit;
        campaign.stomata = to_stomata(draft.water, *campaign.photosynthesis);
        for (ComponentEntry& each : campaign.components)
            if (each.photosynthesis)
                each.stomata = to_stomata(draft.water, *each.photosynthesis);
    }
    std::erase_if(campaign.constraints.traits,
                  [](const TraitConstraint& x) { return !constrains(x); });
    campaign.source = source;
    campaign.resolved = resolved_text(draft);
    campaign.accuracy = accuracy_keys(draft);
    if (campaign.climates.empty()) campaign.sun_dates = 0;
    campaign.sha256 = sha256(campaign.resolved);
    return campaign;
}

//! Checks a draft in which keys have other values than in its file.
void check_again(Draft& draft) {
    Problems problems(draft.campaign.name);
    check_draft(draft, problems);
    problems.throw_if_any();
}

//! Reports ranges of keys whose ends, or a point between them, contradict other
//! keys of the campaign, and notes those in which a search cannot begin.
void try_ranges(Draft& draft, const Problems& problems) {
    constexpr double inner = 0.382;
    const std::string table = draft.is_study ? "sensitivity" : "search";
    const std::vector<KeyFactor>& factors = draft.factors();
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const auto& [key, range, unit, value] = factors[i];
        const Problems own = problems.in(table).in("keys", i);
        if (!draft.is_study && (value < range.lower || value > range.upper))
            draft.campaign.outside_bounds.push_back(
                {own.where("range"),
                 fmt::format("search.keys: {} is {} in this campaign (outside "
                             "the range {} .. {}, but a search begins there); "
                             "widen the range, or give the key another value",
                             key, value, range.lower, range.upper)});
        for (const double part : {0.0, 1.0, inner}) {
            const double at = std::lerp(range.lower, range.upper, part);
            Draft varied = draft;
            set_key(varied, factors[i], at);
            try {
                check_again(varied);
            } catch (const InputError& error) {
                own.add("range", "{}.keys: if {} is {}, then {}", table, key,
                        at, error.problems().front().what);
                break;
            }
        }
    }
}

Campaign parse(const std::string& text, const std::string& file,
               PlantSource source,
               const std::vector<std::string>& settings = {},
               bool is_study = false) {
    Draft draft;
    draft.is_study = is_study;
    Problems problems;
    read_draft(text, file, source, settings, draft, problems);
    read_weathers(file, source, draft, problems);
    read_objects(file, draft, problems);
    check_draft(draft, problems);
    if (problems.empty()) try_ranges(draft, problems);
    problems.throw_if_any();
    Campaign campaign = complete(draft, text);
    check_paths(campaign, problems.in("light"));
    campaign.warnings = problems.warnings();
    if (!campaign.varied.keys.empty())
        campaign.draft = std::make_shared<const Draft>(std::move(draft));
    return campaign;
}

}  // namespace

Campaign read_campaign(const std::string& path,
                       const std::vector<std::string>& settings) {
    return read_campaign_text(read_text(path), path, settings);
}

Campaign read_campaign_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& settings) {
    return parse(text, path, PlantSource::file_or_table, settings);
}

Campaign read_study(const std::string& path,
                    const std::vector<std::string>& settings) {
    // Replicates would repeat the study with other random numbers.
    std::vector<std::string> all{"replicates=1"};
    all.insert(all.end(), settings.begin(), settings.end());
    return parse(read_text(path), path, PlantSource::file_or_table, all, true);
}

Crop read_crop(const std::string& path) {
    const std::string text = read_text(path);
    Draft draft;
    Problems problems;
    if (!read_crop_draft(text, path, draft, problems))
        return parse(text, path, PlantSource::file_or_table).crop;
    check_plant(draft, problems);
    problems.throw_if_any();
    Crop crop = crop_of(draft);
    crop.rules = rule_names(draft);
    return crop;
}

void require_breedable(const Campaign& campaign) {
    if (!campaign.outside_bounds.empty())
        throw InputError(campaign.outside_bounds);
}

std::string crop_text(const Campaign& campaign, const Plant& baseline,
                      std::size_t component) {
    Draft draft;
    Problems problems;
    read_draft(campaign.resolved, campaign.name, PlantSource::table, {}, draft,
               problems);
    Draft& own = component == 0 ? draft : *draft.components.at(component - 1);
    own.campaign.crop.baseline = baseline;
    // A search may turn leaves beyond north, which files may not.
    for (Leaf& leaf : own.campaign.crop.baseline.leaves)
        if (leaf.azimuth < 0 || leaf.azimuth > 360)
            leaf.azimuth -= 360 * std::floor(leaf.azimuth / 360);
    return resolved_plant_text(own);
}

Campaign parse_campaign(const std::string& text, const std::string& file,
                        const std::vector<std::string>& settings) {
    return parse(text, file, PlantSource::table, settings);
}

Campaign at_keys(const Campaign& campaign, Genome& genome) {
    const std::vector<KeyFactor>& keys = campaign.varied.keys;
    const std::size_t plain = count_genes(campaign);
    if (keys.empty() || genome.size() != plain + keys.size()) return campaign;
    Draft draft = *campaign.draft;
    for (std::size_t i = 0; i < keys.size(); ++i)
        set_key(draft, keys[i], genome[plain + i]);
    genome.resize(plain);
    check_again(draft);
    return complete(draft, campaign.source);
}

}  // namespace ideotype
