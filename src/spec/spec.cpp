// SPDX-License-Identifier: Apache-2.0
#include "spec.hpp"

#include <algorithm>

#include "ideotype/canopy/quantities.hpp"

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

std::vector<double> MaterialSpec::in(const std::string& band) const {
    for (std::size_t b = 0; b < wavebands.size(); ++b)
        if (band == wavebands[b].name) return optics[b];
    const auto found = others.find(band);
    return found == others.end() ? std::vector<double>{} : found->second;
}

std::vector<std::string> bands_of(const std::vector<MaterialSpec>& materials) {
    std::set<std::string> names;
    for (const MaterialSpec& material : materials) {
        for (const auto& [band, parts] : material.others) names.insert(band);
        for (const Waveband& band : wavebands)
            if (!material.in(band.name).empty()) names.insert(band.name);
    }
    // PAR comes first, since assimilation is computed from the first band.
    std::vector<std::string> sorted(names.begin(), names.end());
    std::stable_partition(
        sorted.begin(), sorted.end(),
        [](const std::string& band) { return band == "par"; });
    return sorted;
}

CropSpec::CropSpec() {
    // These controls are a least-squares fit of a width profile with a maximum
    // of 1 and an area of 0.7455 length x width.
    baseline.blade.width_controls = {0.28,     0.885870, 0.895017,
                                     1.149943, 0.379696, 0.0};
    // A crop file without traits uses the traits and bounds of the study
    // arXiv:2512.06064. The range of the insertion angle and the rule
    // "biological" are estimates of this project.
    traits = {leaf_trait("length", "m", {0.40, 1.10}),
              leaf_trait("width", "m", {0.05, 0.14}),
              leaf_trait("insertion_angle", "deg", {10, 80}),
              leaf_trait("azimuth", "deg", {0, 360}, true)};
    bounds = {{"paper", "length", {0.40, 1.10}},
              {"biological", "length", {0.40, 1.10}, 0.35},
              {"biological", "width", {0.001, 0.5}, 0.35}};
}

bool constrains(const TraitConstraint& limit) {
    const TraitConstraint none;
    return limit.step > 0 || limit.total.lower > none.total.lower ||
           limit.total.upper < none.total.upper || limit.is_falling ||
           limit.distichous > 0 || limit.range.lower > none.range.lower ||
           limit.range.upper < none.range.upper;
}

bool has_constraints(const Constraints& constraints) {
    const Range any = Constraints{}.lai;
    return constraints.lai.lower > any.lower ||
           constraints.lai.upper < any.upper ||
           std::ranges::any_of(
               constraints.traits,
               [](const TraitConstraint& limit) { return constrains(limit); });
}

ByBand<bool> followed_bands(const Spec& spec) {
    ByBand<bool> follows{true};
    for (std::size_t b = 1; b < wavebands.size(); ++b)
        follows[b] = (b == nir_band && spec.water &&
                      spec.water->rules.has_leaf_temperature) ||
                     std::ranges::count(spec.bands, wavebands[b].name,
                                        &BandEntry::name) > 0;
    return follows;
}

bool plants_grow(const Spec& spec) {
    return std::ranges::any_of(
        spec.climates, [](const auto& each) { return each.value.grows(); });
}

bool is_over(const Spec& spec, const std::string& axis) {
    return std::ranges::count(spec.objective.over, axis) > 0;
}

bool asks_for_assimilation(const Spec& spec) {
    const auto is_of = [](const std::string& name) {
        const std::string quantity = name.substr(name.find('.') + 1);
        return is_of_assimilation(quantity) || is_of_grain(quantity) ||
               is_of_prices(quantity);
    };
    return std::ranges::any_of(spec.objective.maximised, is_of) ||
           std::ranges::any_of(spec.objective.minimised, is_of) ||
           std::ranges::any_of(spec.search.axes, is_of, &AtlasAxis::quantity);
}

std::vector<std::string> rule_names(const CropSpec& crop) {
    std::vector<std::string> names{"traits"};
    for (const BoundsEntry& each : crop.bounds)
        if (std::ranges::count(names, each.rule) == 0)
            names.push_back(each.rule);
    return names;
}

bool is_bred(const CropSpec& crop, const Trait& trait) {
    bool rule_chooses = false;
    for (const BoundsEntry& entry : crop.bounds) {
        if (entry.rule != crop.rule || !entry.is_bred) continue;
        rule_chooses = true;
        if (entry.trait == trait.name) return true;
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

Crop crop_of(const CropSpec& spec) {
    Crop crop;
    crop.baseline = spec.baseline;
    for (const TraitEntry& entry : spec.traits)
        crop.traits.push_back(complete(entry));
    crop.growth = spec.growth;
    crop.grain = spec.grain;
    crop.variation = spec.variation;
    return crop;
}

Range bounds_of(const CropSpec& crop, std::size_t trait, double baseline) {
    if (crop.rule.empty()) return crop.own_bounds.at(trait);
    const Trait& bred = crop.traits.at(trait).trait;
    for (const BoundsEntry& entry : crop.bounds) {
        if (entry.rule != crop.rule || entry.trait != bred.name) continue;
        if (!(entry.change > 0)) return entry.range;
        return {std::max((1 - entry.change) * baseline, entry.range.lower),
                std::min((1 + entry.change) * baseline, entry.range.upper)};
    }
    return bred.range;
}

std::vector<std::string> all_organs(const Plant& plant) {
    std::vector<std::string> names{"stalk", "sheath"};
    if (has_petioles(plant)) names.push_back("petiole");
    for (const Organ& organ : plant.organs) names.push_back(organ.name);
    return names;
}

Soil SoilSpec::soil() const {
    // FAO-56, table 19: the middles of ranges, in the order of Texture.
    constexpr Soil textures[] = {
        {.12, .045, 9, 4.5},     {.15, .065, 11.5, 6},  {.23, .11, 17.5, 8},
        {.25, .12, 19, 9},       {.29, .15, 21.5, 9.5}, {.32, .17, 24, 9.5},
        {.335, .205, 24.5, 9.5}, {.36, .23, 25, 10},    {.36, .22, 25.5, 10}};
    Soil result = textures[static_cast<std::size_t>(texture)];
    result.field_capacity = field_capacity.value_or(result.field_capacity);
    result.wilting_point = wilting_point.value_or(result.wilting_point);
    result.total_evaporable =
        total_evaporable.value_or(result.total_evaporable);
    result.readily_evaporable =
        readily_evaporable.value_or(result.readily_evaporable);
    result.depletion_fraction = depletion_fraction;
    result.curve_number = curve_number;
    return result;
}

}  // namespace ideotype
