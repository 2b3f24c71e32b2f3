// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

void check_leaves(const Plant& plant, Report& report) {
    const Stalk& stalk = plant.stalk;
    const Leaf* below = nullptr;
    for (const Leaf& leaf : plant.leaves) {
        const double& height = leaf.insertion_height;
        if (report.usable({&leaf.length, &leaf.width}) &&
            leaf.width > leaf.length)
            report.add(&leaf.width,
                       fmt::format("leaf.width is {} m (wider than its length "
                                   "of {} m); check the units: both are in m",
                                   leaf.width, leaf.length));
        if (report.usable({&height, &stalk.height}) && height > stalk.height)
            report.add(&height,
                       fmt::format("leaf.insertion_height is {} m (above the "
                                   "stalk's height of {} m); use {} m or less",
                                   height, stalk.height, stalk.height));
        if (below && report.usable({&height, &below->insertion_height}) &&
            height < below->insertion_height)
            report.add(&height,
                       fmt::format("leaf.insertion_height is {} m (below the "
                                   "leaf before it, at {} m); list the lowest "
                                   "leaf first",
                                   height, below->insertion_height));
        below = &leaf;
    }
}

void check_blade(const Blade& blade, Report& report) {
    const std::vector<double>& controls = blade.width_controls;
    if (report.usable({&controls}) &&
        *std::max_element(controls.begin(), controls.end()) <= 0)
        report.add(&controls,
                   "blade.width_controls are all 0 (a blade has a width); "
                   "leave the key out for the usual profile");
}

//! The names of measures begin with those of organs.
void check_organs(const Plant& plant, Report& report) {
    std::set<std::string> names{"leaf", "blade", "stalk", "sheath"};
    for (const Organ& organ : plant.organs) {
        const std::string& name = organ.name;
        if (report.usable({&name}) && !names.insert(name).second)
            report.add(&name,
                       fmt::format("organ.name is \"{}\" (already used); "
                                   "give each organ a name of its own",
                                   name));
        if (report.usable({&organ.leaf}) &&
            organ.leaf > static_cast<int>(plant.leaves.size()))
            report.add(&organ.leaf,
                       fmt::format("organ.leaf is {} (the plant has {} "
                                   "leaves); use one of them, or 0 for the "
                                   "stalk's top",
                                   organ.leaf, plant.leaves.size()));
    }
}

void check_constraints(const Draft& draft, Report& report) {
    const Constraints& constraints = draft.campaign.constraints;
    if (report.usable({&constraints.lai}) && constraints.lai.upper <= 0)
        report.add(&constraints.lai,
                   "constraints.lai allows no leaves (its upper bound is 0); "
                   "write [lower, upper]");
    for (std::size_t t = 0; t < constraints.traits.size(); ++t) {
        const TraitConstraint& limit = constraints.traits[t];
        const Trait trait = complete(draft.traits.at(t));
        if (!constrains(limit) || trait.measures.empty()) continue;
        const std::string& measure = trait.measures.front();
        if (!measure.starts_with("leaf."))
            report.add(&limit.step,
                       fmt::format("constraints.{} is there (the trait acts on "
                                   "{}, which the plant has once); narrow its "
                                   "bounds instead",
                                   trait.name, measure));
        else if (limit.distichous > 0 && measure != "leaf.azimuth")
            report.add(&limit.distichous,
                       fmt::format("constraints.{}.distichous is {} (the trait "
                                   "acts on {}); only azimuths have a plane",
                                   trait.name, limit.distichous, measure));
    }
}

//! Any trait set that breeds a trait, or nullptr.
const Named<TraitSet>* breeder(const Campaign& campaign,
                               const std::string& trait) {
    for (const Named<TraitSet>& set : campaign.trait_sets)
        if (std::find(set.value.begin(), set.value.end(), trait) !=
            set.value.end())
            return &set;
    return nullptr;
}

//! The bred numbers of the baseline must be inside their bounds.
void check_baseline(Draft& draft, Report& report) {
    const bool is_table = draft.rule.empty();
    if (!is_table && !report.usable({&draft.rule})) return;
    Crop crop = draft.campaign.crop;
    for (const TraitEntry& entry : draft.traits)
        crop.traits.push_back(complete(entry));
    const std::vector<TraitNumber> numbers = trait_numbers(crop);
    const std::vector<double> baseline = baseline_numbers(crop);
    // Where the value of a number in the baseline was written.
    const auto place = [&](const TraitNumber& number) -> const void* {
        const Trait& trait = crop.traits[number.trait];
        if (trait.effect != TraitEffect::sets)
            return &draft.traits[number.trait].trait.range;
        const auto measure =
            find_measure(draft.campaign.crop.baseline, trait.measures[0]);
        return measure
            ->values[static_cast<std::size_t>(std::max(number.leaf, 1) - 1)];
    };
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto& [t, leaf, point] = numbers[i];
        const std::string unit =
            crop.traits[t].unit == "1" ? "" : ' ' + crop.traits[t].unit;
        const Trait& trait = crop.traits[t];
        const Named<TraitSet>* set = breeder(draft.campaign, trait.name);
        const void* written = place(numbers[i]);
        if (!set || !report.usable({written})) continue;
        if (is_table && !report.usable({&draft.own_bounds[t]})) continue;
        const Range range = bounds_of(draft, t, baseline[i]);
        if (baseline[i] >= range.lower && baseline[i] <= range.upper) continue;
        report.add(
            written,
            fmt::format(
                "{}{} is {}{} (outside the {} bounds {:.6g} .. {:.6g}{}, and "
                "trait set \"{}\" breeds it); change the baseline, the bounds "
                "or the free traits",
                trait.effect == TraitEffect::sets ? trait.measures[0]
                                                  : "trait " + trait.name,
                leaf > 0 ? fmt::format(" of leaf {}", leaf) : "", baseline[i],
                unit, is_table ? "table's" : '"' + draft.rule + '"',
                range.lower, range.upper, unit, set->name));
    }
}

//! A start has a number of each gene, those that are bred within their bounds.
void check_start(const Draft& draft, Report& report) {
    const std::vector<double>& start = draft.campaign.search.cma.start;
    if (start.empty() || !report.usable({&start, &draft.rule})) return;
    if (draft.campaign.search.optimizer != OptimizerKind::cma_es)
        return report.add(&start,
                          "search.start is given (only CMA-ES begins around a "
                          "plant of its own); leave it out, or use "
                          "search.optimizer = \"cma_es\"");
    Crop crop = draft.campaign.crop;
    for (const TraitEntry& entry : draft.traits)
        crop.traits.push_back(complete(entry));
    const std::vector<TraitNumber> numbers = trait_numbers(crop);
    const std::vector<double> baseline = baseline_numbers(crop);
    if (start.size() != numbers.size())
        return report.add(
            &start, fmt::format("search.start has {} numbers (the traits of "
                                "this crop have {}); begin with run --start "
                                "PLANT, which writes them",
                                start.size(), numbers.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto& [t, leaf, point] = numbers[i];
        const std::string& trait = crop.traits[t].name;
        const Range range = bounds_of(draft, t, baseline[i]);
        if (!breeder(draft.campaign, trait) ||
            (start[i] >= range.lower && start[i] <= range.upper))
            continue;
        report.add(&start,
                   fmt::format("search.start has {:.6g} for {}{} (outside the "
                               "bounds {:.6g} .. {:.6g}); begin with another "
                               "plant, or widen the bounds",
                               start[i], trait,
                               leaf > 0 ? fmt::format(" of leaf {}", leaf) : "",
                               range.lower, range.upper));
    }
}

}  // namespace

void check_plant(Draft& draft, Report& report) {
    const Plant& plant = draft.campaign.crop.baseline;
    check_blade(plant.blade, report);
    check_leaves(plant, report);
    check_organs(plant, report);
    check_traits(draft, report);
}

void check_breeding(Draft& draft, Report& report) {
    if (!draft.is_crop_known) return;
    for (const TraitEntry& entry : draft.traits)
        if (!is_sound(entry, report)) return;
    check_constraints(draft, report);
    check_baseline(draft, report);
    check_start(draft, report);
}

}  // namespace ideotype
