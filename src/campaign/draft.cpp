// SPDX-License-Identifier: Apache-2.0
#include "draft.hpp"

#include <algorithm>

namespace ideotype {

namespace {

TraitEntry leaf_trait(const std::string& name, const std::string& unit,
                      Range range, bool is_circular = false) {
    TraitEntry entry;
    entry.trait.name = name;
    entry.trait.unit = unit;
    entry.trait.range = range;
    entry.trait.is_circular = is_circular;
    entry.sets = {"leaf." + name};
    return entry;
}

}  // namespace

Draft::Draft() {
    // `fidelity` recommends this accuracy; the defaults of the field and the
    // time step already fit.
    campaign.sampling = {16384, 16, 0.005};
    campaign.trait_sets = {{"all", {}}};
    // The controls are a least-squares fit of a width profile with a maximum of
    // 1 and an area of 0.7455 length x width.
    campaign.crop.baseline.blade.width_controls = {0.28,     0.885870, 0.895017,
                                                   1.149943, 0.379696, 0.0};
    // A crop file without traits has the traits and bounds of the study
    // arXiv:2512.06064; the range of the insertion angle and the rule
    // "biological" are estimates of this project.
    traits = {leaf_trait("length", "m", {0.40, 1.10}),
              leaf_trait("width", "m", {0.05, 0.14}),
              leaf_trait("insertion_angle", "deg", {10, 80}),
              leaf_trait("azimuth", "deg", {0, 360}, true)};
    bounds = {{"paper", "length", {0.40, 1.10}},
              {"biological", "length", {0.40, 1.10}, 0.35},
              {"biological", "width", {0.001, 0.5}, 0.35}};
}

std::vector<std::string> rule_names(const Draft& draft) {
    std::vector<std::string> names{"traits"};
    for (const BoundsEntry& each : draft.bounds)
        if (std::ranges::count(names, each.rule) == 0)
            names.push_back(each.rule);
    return names;
}

bool is_bred(const Draft& draft, const Trait& trait, const std::string& rule) {
    bool rule_chooses = false;
    for (const BoundsEntry& each : draft.bounds) {
        if (each.rule != rule || !each.is_bred) continue;
        rule_chooses = true;
        if (each.trait == trait.name) return true;
    }
    return !rule_chooses && trait.is_bred;
}

const std::vector<std::string>& measures_of(const TraitEntry& entry) {
    if (!entry.sets.empty()) return entry.sets;
    return entry.scales.empty() ? entry.shifts : entry.scales;
}

Trait complete(const TraitEntry& entry) {
    Trait trait = entry.trait;
    trait.measures = measures_of(entry);
    trait.effect = !entry.sets.empty()     ? TraitEffect::sets
                   : !entry.scales.empty() ? TraitEffect::scales
                                           : TraitEffect::shifts;
    return trait;
}

bool plants_grow(const Campaign& campaign) {
    return std::ranges::any_of(
        campaign.climates, [](const auto& each) { return each.value.grows(); });
}

Crop crop_of(const Draft& draft) {
    Crop crop = draft.campaign.crop;
    for (const TraitEntry& entry : draft.traits)
        crop.traits.push_back(complete(entry));
    if (draft.has_growth) crop.growth = draft.growth;
    crop.variation = draft.crop_variation;
    return crop;
}

Range bounds_of(const Draft& draft, std::size_t trait, double baseline) {
    if (draft.rule.empty()) return draft.own_bounds.at(trait);
    const Trait& bred = draft.traits.at(trait).trait;
    for (const BoundsEntry& each : draft.bounds) {
        if (each.rule != draft.rule || each.trait != bred.name) continue;
        if (!(each.change > 0)) return each.range;
        return {std::max((1 - each.change) * baseline, each.range.lower),
                std::min((1 + each.change) * baseline, each.range.upper)};
    }
    return bred.range;
}

}  // namespace ideotype
