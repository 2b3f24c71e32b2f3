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
        const auto& [lower, upper] = trait_.range;
        constexpr double circle = 360;
        problems_.rule({"name"}, lists != 1,
                       "trait {} has {} of the lists sets, scales and shifts "
                       "(each trait has one of them); give one",
                       trait_.name, lists == 0 ? "none" : "several");
        if (lists != 1) return;
        rule(sets() && list_.size() > 1,
             "sets several measures (they would all be the same number); scale "
             "or shift them");
        rule(sets() && trait_.numbers == TraitNumbers::profile,
             "sets a measure by a profile (the baseline need not be one); "
             "scale or shift it");
        problems_.rule({"over_density", list_key()}, trait_.is_slope && sets(),
                       "trait {} sets a measure over density (a slope can only "
                       "scale or shift it); scale or shift it",
                       trait_.name);
        problems_.rule(
            {"over_density"},
            trait_.is_slope && !(plant_.plasticity.reference > 0),
            "trait {} is a slope over density (the crop file has no density "
            "at which it has no effect); give [plasticity] with reference",
            trait_.name);
        if (!problems_.usable({list_key()})) return;
        for (const std::string& name : list_)
            if (const auto measure = find_measure(plant_, name))
                check(name, *measure);
            else
                report_unknown(name);
        problems_.rule({"range"},
                       trait_.effect == TraitEffect::scales &&
                           !trait_.is_slope && lower < 0,
                       "trait {} has the range {} .. {} (a factor below 0 "
                       "reverses a measure); begin at 0 or more",
                       trait_.name, lower, upper);
        problems_.rule({"circular", "range"},
                       trait_.is_circular &&
                           (trait_.unit != "deg" || upper - lower != circle),
                       "trait {} is circular (its range of {} .. {} {} is not "
                       "a full circle); give it 360 deg, or remove circular",
                       trait_.name, lower, upper, trait_.unit);
    }

  private:
    bool sets() const { return trait_.effect == TraitEffect::sets; }

    std::string list_key() const {
        return !entry_.sets.empty()     ? "sets"
               : !entry_.scales.empty() ? "scales"
                                        : "shifts";
    }

    void rule(bool is_broken, const std::string& text) {
        problems_.rule({list_key()}, is_broken, "trait {} {}", trait_.name,
                       text);
    }

    void check(const std::string& name, const MeasureInfo& measure) {
        const bool is_per_plant = trait_.numbers == TraitNumbers::plant;
        const std::string unit =
            trait_.effect == TraitEffect::scales ? "1" : measure.unit;
        const auto& [least, most] = measure.limits;
        rule(!is_per_plant && !measure.is_of_leaves,
             "acts on " + name +
                 " (which the plant has once, but the trait has several "
                 "numbers); write per = \"plant\"");
        rule(is_per_plant && measure.is_of_leaves && sets(),
             "sets " + name +
                 " (each leaf has its own value); scale or shift it, or write "
                 "per = \"leaf\"");
        rule(follows_internodes(plant_, name),
             "acts on " + name +
                 " (which follows from the internodes); act on leaf.internode");
        problems_.rule({"unit", list_key()}, trait_.unit != unit,
                       "trait {} has the unit \"{}\" (its numbers for {} have "
                       "\"{}\"); write unit = \"{}\"",
                       trait_.name, trait_.unit, name, unit, unit);
        problems_.rule(
            {"range", list_key()},
            sets() && (trait_.range.lower < least || trait_.range.upper > most),
            "trait {} has the range {} .. {} (the widest range for {} is {} .. "
            "{}); narrow it",
            trait_.name, trait_.range.lower, trait_.range.upper, name, least,
            most);
    }

    void report_unknown(const std::string& name) {
        problems_.add(
            list_key(), ProblemCode::unknown_name,
            "trait {} acts on \"{}\" (the plant has no such measure); {}",
            trait_.name, name, did_you_mean(name, measure_names(plant_)));
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
        const Problems of_trait = problems.in("trait", t);
        const std::string& name = crop.traits[t].trait.name;
        of_trait.rule(
            ProblemCode::duplicate, {"name"},
            [&] { return !names.insert(name).second; },
            "trait.name is \"{}\" (already used); give each trait a different "
            "name",
            name);
        if (is_sound(t, problems))
            TraitCheck(crop.traits[t], crop.baseline, of_trait).run();
    }
    for (std::size_t b = 0; b < crop.bounds.size(); ++b) {
        const std::string& trait = crop.bounds[b].trait;
        problems.in("bounds", b)
            .rule(ProblemCode::unknown_name, {"trait"}, !names.contains(trait),
                  "bounds.trait is \"{}\" (not a trait of this file); use one "
                  "of {}",
                  trait, fmt::join(names, ", "));
    }
}

}  // namespace ideotype
