// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <set>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checks.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

void check_leaves(const Plant& plant, Problems& problems) {
    const Stalk& stalk = plant.stalk;
    const Leaf* below = nullptr;
    for (const Leaf& leaf : plant.leaves) {
        const double& height = leaf.insertion_height;
        if (Leaf line = leaf; !leaf.midrib.empty() && !measure_midrib(line))
            problems.add(&leaf.midrib,
                         "leaf.midrib has no two points that differ (a line "
                         "needs a direction); give the points from the base to "
                         "the tip");
        if (problems.usable({&leaf.length, &leaf.width}) &&
            leaf.width > leaf.length)
            problems.add(
                &leaf.width,
                fmt::format("leaf.width is {} m (wider than its length "
                            "of {} m); check the units: both are in m",
                            leaf.width, leaf.length));
        if (problems.usable({&height, &stalk.height}) && height > stalk.height)
            problems.add(
                &height,
                fmt::format("leaf.insertion_height is {} m (above the "
                            "stalk's height of {} m); use {} m or less",
                            height, stalk.height, stalk.height));
        if (below && problems.usable({&height, &below->insertion_height}) &&
            height < below->insertion_height)
            problems.add(
                &height,
                fmt::format("leaf.insertion_height is {} m (below the "
                            "leaf before it, at {} m); list the lowest "
                            "leaf first",
                            height, below->insertion_height));
        below = &leaf;
    }
}

void check_blade(const Blade& blade, Problems& problems) {
    const std::vector<double>& controls = blade.width_controls;
    constexpr double least = 1e-6;  // others cannot be scaled to 1
    if (problems.usable({&controls}) &&
        *std::max_element(controls.begin(), controls.end()) < least)
        problems.add(&controls,
                     "blade.width_controls are all 0 (a blade has a width); "
                     "leave the key out for the usual profile");
    if (problems.usable({&blade.leaflets, &blade.leaflet_divergence}) &&
        blade.leaflets > 1 && blade.leaflet_divergence == 0)
        problems.add(
            &blade.leaflets,
            fmt::format("blade.leaflets is {} (all of them would point "
                        "the same way); give their "
                        "leaflet_divergence, such as 80 deg",
                        blade.leaflets));
}

//! The names of measures begin with those of organs.
void check_organs(const Plant& plant, Problems& problems) {
    std::set<std::string> names{"leaf", "blade", "stalk", "sheath", "petiole"};
    for (const Organ& organ : plant.organs) {
        const std::string& name = organ.name;
        if (problems.usable({&name}) && !names.insert(name).second)
            problems.add(&name,
                         fmt::format("organ.name is \"{}\" (already used); "
                                     "give each organ a name of its own",
                                     name));
        if (problems.usable({&organ.leaf}) &&
            organ.leaf > static_cast<int>(plant.leaves.size()))
            problems.add(&organ.leaf,
                         fmt::format("organ.leaf is {} (the plant has {} "
                                     "leaves); use one of them, or 0 for the "
                                     "stalk's top",
                                     organ.leaf, plant.leaves.size()));
    }
}

void check_constraints(const Draft& draft, Problems& problems) {
    const Constraints& constraints = draft.campaign.constraints;
    if (problems.usable({&constraints.lai}) && constraints.lai.upper <= 0)
        problems.add(&constraints.lai,
                     "constraints.lai allows no leaves (its upper bound is 0); "
                     "write [lower, upper]");
    for (std::size_t t = 0; t < constraints.traits.size(); ++t) {
        const TraitConstraint& limit = constraints.traits[t];
        const Trait trait = complete(draft.traits.at(t));
        if (!constrains(limit) || trait.measures.empty()) continue;
        const std::string& measure = trait.measures.front();
        if (!measure.starts_with("leaf."))
            problems.add(
                &limit.step,
                fmt::format("constraints.{} is there (the trait acts on "
                            "{}, which the plant has once); narrow its "
                            "bounds instead",
                            trait.name, measure));
        else if (limit.distichous > 0 && measure != "leaf.azimuth")
            problems.add(
                &limit.distichous,
                fmt::format("constraints.{}.distichous is {} (the trait "
                            "acts on {}); only azimuths have a plane",
                            trait.name, limit.distichous, measure));
    }
}

//! Any trait set that breeds a trait, or nullptr.
const Named<TraitSet>* breeder(const Campaign& campaign,
                               const std::string& trait) {
    if (!campaign.varied.has_traits) return nullptr;
    for (const Named<TraitSet>& set : campaign.trait_sets)
        if (std::find(set.value.begin(), set.value.end(), trait) !=
            set.value.end())
            return &set;
    return nullptr;
}

//! Notes numbers of a baseline that are outside the bounds in which they would
//! be bred, and the bounds to write.
class BaselineCheck {
  public:
    //! @param parent of the bounds: "plant" or "component"
    BaselineCheck(Draft& draft, const std::string& parent,
                  const Problems& problems)
        : draft_(draft),
          table_(parent + ".bounds"),
          problems_(problems),
          crop_(crop_of(draft)) {
        wider_.resize(crop_.traits.size());
    }

    std::vector<Problem> run() {
        const bool is_table = draft_.rule.empty();
        if (!is_table && !problems_.usable({&draft_.rule})) return {};
        const std::vector<TraitNumber> numbers = trait_numbers(crop_);
        const std::vector<double> baseline = baseline_numbers(crop_);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (!is_table ||
                problems_.usable({&draft_.own_bounds[numbers[i].trait]}))
                check(numbers[i], baseline[i]);
        if (found_.empty()) return {};
        found_ = problems_.sorted(std::move(found_));
        found_.push_back(
            {problems_.where(is_table
                                 ? static_cast<void*>(&draft_.own_bounds[0])
                                 : &draft_.rule),
             fmt::format("{0} leave the baseline out (what is bred begins "
                         "with it); {1}{2}",
                         table_,
                         is_table
                             ? "write in [" + table_ + "]:"
                             : "delete bounds = \"...\" if it is there, "
                               "and add " +
                                   place_of_table() + ":\n[" + table_ + ']',
                         lines())});
        return std::move(found_);
    }

  private:
    bool is_of_component() const { return table_ == "component.bounds"; }

    std::string place_of_table() const {
        return is_of_component() ? "below the keys of its [[component]]"
                                 : "at the end of the campaign";
    }

    void check(const TraitNumber& number, double value) {
        const Trait& trait = crop_.traits[number.trait];
        const Named<TraitSet>* set = breeder(draft_.campaign, trait.name);
        const void* written = place(number);
        if (!set || !problems_.usable({written})) return;
        const Range range = bounds_of(draft_, number.trait, value);
        std::optional<Range>& wider = wider_[number.trait];
        if (!wider) wider = range;
        wider = {std::min({wider->lower, range.lower, value}),
                 std::max({wider->upper, range.upper, value})};
        if (value >= range.lower && value <= range.upper) return;
        const std::string unit = trait.unit == "1" ? "" : ' ' + trait.unit;
        found_.push_back(
            {problems_.where(written),
             fmt::format(
                 "{}{} is {}{} (outside the {} bounds {:.6g} .. {:.6g}{}, and "
                 "{} breeds it); change the baseline, the bounds or the free "
                 "traits",
                 trait.effect == TraitEffect::sets ? trait.measures[0]
                                                   : "trait " + trait.name,
                 number.leaf > 0 ? fmt::format(" of leaf {}", number.leaf) : "",
                 value, unit,
                 draft_.rule.empty() ? "table's" : '"' + draft_.rule + '"',
                 range.lower, range.upper, unit,
                 is_of_component() ? "component.free"
                                   : "trait set \"" + set->name + '"')});
    }

    //! Returns the address of the value that a number of the baseline was
    //! written in.
    const void* place(const TraitNumber& number) {
        const Trait& trait = crop_.traits[number.trait];
        if (trait.effect != TraitEffect::sets)
            return &draft_.traits[number.trait].trait.range;
        const auto measure =
            find_measure(draft_.campaign.crop.baseline, trait.measures[0]);
        return measure
            ->values[static_cast<std::size_t>(std::max(number.leaf, 1) - 1)];
    }

    //! The bred traits whose bounds are not those that a table begins with,
    //! and which traits are bred if the rule that the table replaces tells.
    std::string lines() const {
        std::string text;
        for (std::size_t t = 0; t < wider_.size(); ++t) {
            const Range usual = draft_.rule.empty() ? draft_.own_bounds[t]
                                                    : crop_.traits[t].range;
            if (wider_[t] && (wider_[t]->lower != usual.lower ||
                              wider_[t]->upper != usual.upper))
                text += fmt::format("\n{} = [{}, {}]", crop_.traits[t].name,
                                    wider_[t]->lower, wider_[t]->upper);
        }
        TraitSet by_rule, by_table;
        for (const TraitEntry& entry : draft_.traits) {
            if (is_bred(draft_, entry.trait, draft_.rule))
                by_rule.push_back(entry.trait.name);
            if (entry.trait.is_bred) by_table.push_back(entry.trait.name);
        }
        const Named<TraitSet>& first = draft_.campaign.trait_sets.front();
        if (!is_of_component() && by_rule != by_table && first.value == by_rule)
            text += fmt::format("\n[[traits]]\nname = \"{}\"\nfree = [\"{}\"]",
                                first.name, fmt::join(by_rule, "\", \""));
        return text;
    }

    Draft& draft_;
    std::string table_;  //!< of own bounds
    const Problems& problems_;
    Crop crop_;
    //! The bounds of each bred trait, widened to hold the baseline's numbers.
    std::vector<std::optional<Range>> wider_;
    std::vector<Problem> found_;
};

//! Returns the drafts of what is bred in the order of genes: the campaign's
//! crop, then components.
std::vector<Draft*> bred_drafts(Draft& draft) {
    std::vector<Draft*> all{&draft};
    for (const std::shared_ptr<Draft>& each : draft.components)
        if (!each->campaign.trait_sets.front().value.empty())
            all.push_back(each.get());
    return all;
}

//! Tells numbers of a start that are outside the bounds of a crop.
//! @param start its numbers begin there
//! @returns how many numbers the crop has
std::size_t check_start_of(const Draft& draft, std::span<const double> start,
                           const void* place, Problems& problems) {
    const Crop crop = crop_of(draft);
    const std::vector<TraitNumber> numbers = trait_numbers(crop);
    const std::vector<double> baseline = baseline_numbers(crop);
    for (std::size_t i = 0; i < std::min(numbers.size(), start.size()); ++i) {
        const auto& [t, leaf, point] = numbers[i];
        const std::string& trait = crop.traits[t].name;
        const Range range = bounds_of(draft, t, baseline[i]);
        if (!breeder(draft.campaign, trait) ||
            (start[i] >= range.lower && start[i] <= range.upper))
            continue;
        problems.add(
            place, fmt::format("search.start has {:.6g} for {}{} (outside the "
                               "bounds {:.6g} .. {:.6g}); begin with another "
                               "plant, or widen the bounds",
                               start[i], trait,
                               leaf > 0 ? fmt::format(" of leaf {}", leaf) : "",
                               range.lower, range.upper));
    }
    return numbers.size();
}

//! A start has a number of each gene, those that are bred within their bounds.
void check_start(Draft& draft, Problems& problems) {
    const std::vector<double>& start = draft.campaign.search.start;
    if (start.empty() || !problems.usable({&start, &draft.rule})) return;
    if (!uses_cma_es(draft.campaign.search))
        return problems.add(
            &start,
            "search.start is given (only CMA-ES begins around a "
            "plant of its own); leave it out, or use "
            "search.optimizer = \"auto\"");
    std::size_t count = 0;
    for (Draft* each : bred_drafts(draft))
        count += check_start_of(
            *each, std::span(start).subspan(std::min(count, start.size())),
            &start, problems);
    if (start.size() != count)
        problems.add(&start,
                     fmt::format("search.start has {} numbers (the traits that "
                                 "can be bred have {}); begin with run --start "
                                 "PLANT, which writes them",
                                 start.size(), count));
}

//! Tells growth whose dates contradict each other or the plant.
void check_growth(const Draft& draft, Problems& problems) {
    const Growth& growth = draft.growth;
    const auto leaves =
        static_cast<int>(draft.campaign.crop.baseline.leaves.size());
    if (!draft.has_growth || !problems.usable({&growth.leaves})) return;
    if (growth.leaves < leaves)
        problems.add(
            &growth.leaves,
            fmt::format("growth.leaves is {} (the plant has {} leaves, "
                        "the highest of those that grow); use {} or more",
                        growth.leaves, leaves, leaves));
    for (const auto& [name, share] : {std::pair("largest", &growth.largest),
                                      std::pair("slowest", &growth.slowest)})
        if (problems.usable({share}) && *share * growth.leaves <= 1)
            problems.add(
                share,
                fmt::format("growth.{} is {} (of {} leaves, below the "
                            "second one); use more than {:.3g}",
                            name, *share, growth.leaves, 1. / growth.leaves));
}

}  // namespace

void check_plant(Draft& draft, Problems& problems) {
    const Plant& plant = draft.campaign.crop.baseline;
    check_blade(plant.blade, problems);
    check_leaves(plant, problems);
    check_organs(plant, problems);
    check_growth(draft, problems);
    check_traits(draft, problems);
}

void check_breeding(Draft& draft, Problems& problems) {
    if (!draft.is_crop_known) return;
    for (const TraitEntry& entry : draft.traits)
        if (!is_sound(entry, problems)) return;
    check_constraints(draft, problems);
    std::vector<Problem>& outside = draft.campaign.outside_bounds;
    outside.clear();
    for (Draft* each : bred_drafts(draft))
        if (each->is_crop_known)
            std::ranges::move(
                BaselineCheck(*each, each == &draft ? "plant" : "component",
                              problems)
                    .run(),
                std::back_inserter(outside));
    check_start(draft, problems);
}

}  // namespace ideotype
