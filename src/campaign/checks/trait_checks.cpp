// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checks.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

class TraitCheck {
  public:
    TraitCheck(const TraitEntry& entry, const Plant& plant,
               const Problems& problems)
        : entry_(entry),
          trait_(complete(entry)),
          list_(measures_of(entry)),
          plant_(plant),
          problems_(problems) {}

    void run() {
        const int lists = !entry_.sets.empty() + !entry_.scales.empty() +
                          !entry_.shifts.empty();
        if (lists != 1)
            return problems_.add(
                "name",
                "trait {} has {} of the lists sets, scales and shifts (each "
                "trait has one of them); give one",
                trait_.name, lists == 0 ? "none" : "several");
        if (trait_.effect == TraitEffect::sets &&
            (list_.size() > 1 || trait_.numbers == TraitNumbers::profile))
            return fail(list_.size() > 1
                            ? "sets several measures (they would all be the "
                              "same number); scale or shift them"
                            : "sets a measure by a profile (the baseline need "
                              "not be one); scale or shift it");
        for (const std::string& name : list_) check(name);
        check_range();
    }

  private:
    void fail(const std::string& what) {
        const char* const list = !entry_.sets.empty()     ? "sets"
                                 : !entry_.scales.empty() ? "scales"
                                                          : "shifts";
        problems_.add(list, "trait {} {}", trait_.name, what);
    }

    void check(const std::string& name) {
        const auto measure = find_measure(plant_, name);
        if (!measure) return fail_unknown(name);
        const bool is_per_plant = trait_.numbers == TraitNumbers::plant;
        if (!is_per_plant && !measure->is_of_leaves)
            return fail(fmt::format(
                "acts on {} (which the plant has once, but the trait has "
                "several numbers); write per = \"plant\"",
                name));
        if (is_per_plant && measure->is_of_leaves &&
            trait_.effect == TraitEffect::sets)
            return fail(
                fmt::format("sets {} (each leaf has a value of its own); scale "
                            "or shift it, or write per = \"leaf\"",
                            name));
        const std::vector<Leaf>& leaves = plant_.leaves;
        if ((name == "leaf.insertion_height" || name == "stalk.height") &&
            !leaves.empty() && leaves.back().internode > 0)
            return fail(
                fmt::format("acts on {} (which follows from the "
                            "internodes); act on leaf.internode",
                            name));
        const std::string unit =
            trait_.effect == TraitEffect::scales ? "1" : measure->unit;
        if (problems_.usable({"unit"}) && trait_.unit != unit)
            problems_.add("unit",
                          "trait {} has the unit \"{}\" (its numbers for {} "
                          "have \"{}\"); write unit = \"{}\"",
                          trait_.name, trait_.unit, name, unit, unit);
        const auto& [least, most] = measure->limits;
        if (trait_.effect == TraitEffect::sets &&
            (trait_.range.lower < least || trait_.range.upper > most))
            problems_.add("range",
                          "trait {} has the range {} .. {} (the widest range "
                          "for {} is {} .. {}); narrow it",
                          trait_.name, trait_.range.lower, trait_.range.upper,
                          name, least, most);
    }

    void fail_unknown(const std::string& name) {
        std::vector<std::string> known;
        for (const MeasureInfo& each : measures(plant_))
            known.push_back(each.name);
        fail(fmt::format("acts on \"{}\" (the plant has no such measure); {}",
                         name, did_you_mean(name, known)));
    }

    void check_range() {
        constexpr double circle = 360;
        const auto& [lower, upper] = trait_.range;
        if (!problems_.usable({"range"})) return;
        if (trait_.effect == TraitEffect::scales && lower < 0)
            problems_.add("range",
                          "trait {} has the range {} .. {} (a factor below 0 "
                          "turns a measure around); begin at 0 or more",
                          trait_.name, lower, upper);
        if (trait_.is_circular &&
            (trait_.unit != "deg" || upper - lower != circle))
            problems_.add(
                "circular",
                "trait {} is circular (its range of {} .. {} {} is no whole "
                "circle); give it 360 deg, or remove circular",
                trait_.name, lower, upper, trait_.unit);
    }

    const TraitEntry& entry_;
    Trait trait_;
    const std::vector<std::string>& list_;
    Plant plant_;
    Problems problems_;
};

}  // namespace

bool is_sound(std::size_t trait, const Problems& problems) {
    return problems.in("trait", trait)
        .usable(
            {"name", "points", "range", "unit", "sets", "scales", "shifts"});
}

void check_traits(const CropSpec& crop, const Problems& problems) {
    std::set<std::string> names{"lai"};
    for (std::size_t t = 0; t < crop.traits.size(); ++t) {
        const Problems own = problems.in("trait", t);
        const std::string& name = crop.traits[t].trait.name;
        if (own.usable({"name"}) && !names.insert(name).second)
            own.add("name",
                    "trait.name is \"{}\" (already used); give each trait a "
                    "name of its own",
                    name);
        if (is_sound(t, problems))
            TraitCheck(crop.traits[t], crop.baseline, own).run();
    }
    for (std::size_t b = 0; b < crop.bounds.size(); ++b) {
        const Problems own = problems.in("bounds", b);
        const std::string& trait = crop.bounds[b].trait;
        if (own.usable({"trait"}) && !names.contains(trait))
            own.add("trait",
                    "bounds.trait is \"{}\" (no trait of this file); use one "
                    "of {}",
                    trait, fmt::join(names, ", "));
    }
}

}  // namespace ideotype
