// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checks.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

//! An optimised crop. Crops are in the order of genes: first the main crop,
//! then the components.
struct BredCrop {
    const CropSpec& crop;
    std::vector<NamedTraits> sets;  //!< sets of its free traits
    std::string table;  //!< table of its bounds: "plant", "component"
    Problems of_table;  //!< problems of "plant" or "component[0]"
    //! Problems of "plant.baseline" or "component[0].crop".
    Problems of_baseline;

    bool is_component() const { return table == "component"; }

    //! Returns the first trait set in which a trait is free; null if there is
    //! none.
    const NamedTraits* breeder(const std::string& trait) const {
        for (const NamedTraits& set : sets)
            if (std::ranges::count(set.value, trait) > 0) return &set;
        return nullptr;
    }
};

std::vector<BredCrop> bred_crops(const Spec& spec, const Problems& problems) {
    const bool are_varied = !spec.is_study || spec.sensitivity.has_traits;
    std::vector<BredCrop> crops{
        {spec.plant.crop,
         are_varied ? spec.trait_sets : std::vector<NamedTraits>{}, "plant",
         problems.in("plant"), problems.in("plant.baseline")}};
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        const ComponentSpec& component = spec.components[i];
        const Problems of_component = problems.in("component", i);
        if (!component.free.empty())
            crops.push_back({component.crop,
                             {{"all", component.free}},
                             "component",
                             of_component,
                             of_component.in("crop")});
    }
    return crops;
}

void check_constraints(const Spec& spec, const Problems& problems) {
    const Constraints& constraints = spec.constraints;
    problems.rule({"lai"}, constraints.lai.upper <= 0,
                  "constraints.lai allows no leaves (its upper bound is 0); "
                  "write [lower, upper]");
    for (const TraitConstraint& limit : constraints.traits) {
        const Trait trait = complete(*std::ranges::find(
            spec.plant.crop.traits, limit.trait,
            [](const TraitEntry& each) { return each.trait.name; }));
        if (!constrains(limit) || trait.measures.empty()) continue;
        const Problems of_trait = problems.in(limit.trait);
        const std::string& measure = trait.measures.front();
        of_trait.rule(
            {"step"}, !measure.starts_with("leaf."),
            "constraints.{} compares leaves (its trait acts on {}, which the "
            "plant has once); remove it, and narrow the bounds of the trait",
            trait.name, measure);
        of_trait.rule(
            {"distichous", "step"},
            limit.distichous > 0 && measure != "leaf.azimuth",
            "constraints.{}.distichous is {} (its trait acts on {}, and "
            "only azimuths have a plane); remove it",
            trait.name, limit.distichous, measure);
    }
}

//! Returns the path of a measure in a crop, such as "leaf[2].length".
//! @param leaf rank of the leaf, if it is a measure of leaves
std::string key_of(const Plant& plant, const std::string& measure, int leaf) {
    const std::string part = measure.substr(0, measure.find('.')),
                      rest = measure.substr(part.size());
    if (part == "leaf")
        return fmt::format("leaf[{}]{}", std::max(leaf, 1) - 1, rest);
    for (std::size_t i = 0; i < plant.organs.size(); ++i)
        if (plant.organs[i].name == part)
            return fmt::format("organ[{}]{}", i, rest);
    return measure;
}

//! Finds trait values of a baseline outside the bounds of the search, and lines
//! that would correct the bounds.
class BaselineCheck {
  public:
    explicit BaselineCheck(const BredCrop& bred)
        : bred_(bred),
          spec_(bred.crop),
          table_(bred.table + ".bounds"),
          crop_(crop_of(bred.crop)),
          wider_(crop_.traits.size()) {}

    std::vector<Problem> run() {
        const bool is_table = spec_.rule.empty();
        const Problems& problems = bred_.of_table;
        if (!is_table && !problems.usable({"bounds"})) return {};
        const std::vector<TraitNumber> numbers = trait_numbers(crop_);
        const std::vector<double> baseline = baseline_numbers(crop_);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (!is_table || problems.usable({own_bounds(numbers[i].trait)}))
                check(numbers[i], baseline[i]);
        if (found_.empty()) return {};
        found_ = problems.sorted(std::move(found_));
        found_.push_back(problems.problem(
            is_table ? own_bounds(0) : "bounds", ProblemCode::contradiction,
            fmt::format(
                "{0} exclude the baseline (from which the search starts); "
                "{1}{2}",
                table_,
                is_table ? "write in [" + table_ + "]:"
                         : "delete bounds = \"...\" if it is there, and add " +
                               place_of_table() + ":\n[" + table_ + ']',
                lines())));
        return std::move(found_);
    }

    //! Returns a table of bounds that include the baseline.
    std::string wider_bounds() const { return '[' + table_ + ']' + lines(); }

  private:
    std::string own_bounds(std::size_t trait) const {
        return "bounds." + crop_.traits[trait].name;
    }

    std::string place_of_table() const {
        return bred_.is_component() ? "below the keys of its [[component]]"
                                    : "at the end of the campaign";
    }

    void check(const TraitNumber& number, double value) {
        const Trait& trait = crop_.traits[number.trait];
        const NamedTraits* set = bred_.breeder(trait.name);
        const std::string key =
            trait.effect == TraitEffect::sets
                ? key_of(crop_.baseline, trait.measures[0], number.leaf)
                : fmt::format("trait[{}].range", number.trait);
        if (!set || !bred_.of_baseline.usable({key})) return;
        const Range range = bounds_of(spec_, number.trait, value);
        std::optional<Range>& wider = wider_[number.trait];
        if (!wider) wider = range;
        wider = {std::min({wider->lower, range.lower, value}),
                 std::max({wider->upper, range.upper, value})};
        if (value >= range.lower && value <= range.upper) return;
        const std::string unit = trait.unit == "1" ? "" : ' ' + trait.unit;
        found_.push_back(bred_.of_baseline.problem(
            key, ProblemCode::contradiction,
            fmt::format(
                "{}{} is {}{} (outside the {} bounds {:.6g} .. {:.6g}{}, and "
                "{} frees it); change the baseline, the bounds or the free "
                "traits",
                trait.effect == TraitEffect::sets ? trait.measures[0]
                                                  : "trait " + trait.name,
                number.leaf > 0 ? fmt::format(" of leaf {}", number.leaf) : "",
                value, unit,
                spec_.rule.empty() ? "table's" : '"' + spec_.rule + '"',
                range.lower, range.upper, unit,
                bred_.is_component() ? "component.free"
                                     : "trait set \"" + set->name + '"')));
    }

    //! Returns a line for each free trait with bounds that differ from the
    //! table's defaults. If the rule to be replaced chose the free traits, adds
    //! their list.
    std::string lines() const {
        std::string text;
        for (std::size_t t = 0; t < wider_.size(); ++t) {
            const Range usual = spec_.rule.empty() ? spec_.own_bounds[t]
                                                   : crop_.traits[t].range;
            if (wider_[t] && (wider_[t]->lower != usual.lower ||
                              wider_[t]->upper != usual.upper))
                text += fmt::format("\n{} = [{}, {}]", crop_.traits[t].name,
                                    wider_[t]->lower, wider_[t]->upper);
        }
        TraitSet by_rule, by_table;
        for (const TraitEntry& entry : spec_.traits) {
            if (is_bred(spec_, entry.trait))
                by_rule.push_back(entry.trait.name);
            if (entry.trait.is_bred) by_table.push_back(entry.trait.name);
        }
        const NamedTraits& first = bred_.sets.front();
        if (!bred_.is_component() && by_rule != by_table &&
            first.value == by_rule)
            text += fmt::format("\n[[traits]]\nname = \"{}\"\nfree = [\"{}\"]",
                                first.name, fmt::join(by_rule, "\", \""));
        return text;
    }

    const BredCrop& bred_;
    const CropSpec& spec_;
    std::string table_;  //!< table of bounds
    Crop crop_;
    //! Bounds of each free trait, widened to include the baseline.
    std::vector<std::optional<Range>> wider_;
    std::vector<Problem> found_;
};

//! Reports those values of search.start that are outside the bounds of a crop.
//! @param start values of search.start from this crop on
//! @returns the number of genes of the crop
std::size_t check_start_of(const BredCrop& bred, std::span<const double> start,
                           const Problems& problems) {
    const Crop crop = crop_of(bred.crop);
    const std::vector<TraitNumber> numbers = trait_numbers(crop);
    const std::vector<double> baseline = baseline_numbers(crop);
    for (std::size_t i = 0; i < std::min(numbers.size(), start.size()); ++i) {
        const auto& [t, leaf, point] = numbers[i];
        const std::string& trait = crop.traits[t].name;
        const Range range = bounds_of(bred.crop, t, baseline[i]);
        if (!bred.breeder(trait) ||
            (start[i] >= range.lower && start[i] <= range.upper))
            continue;
        problems.add(
            "search.start", ProblemCode::contradiction,
            "search.start has {:.6g} for {}{} (outside the bounds {:.6g} .. "
            "{:.6g}); start from another plant, or widen the bounds",
            start[i], trait, leaf > 0 ? fmt::format(" of leaf {}", leaf) : "",
            range.lower, range.upper);
    }
    return numbers.size();
}

//! Checks that search.start contains one value for each gene, and that values
//! of free genes are within the bounds.
void check_start(const Spec& spec, const Problems& problems) {
    const std::vector<double>& start = spec.search.start;
    const Keys keys{"search.start", "plant.bounds"};
    if (start.empty()) return;
    problems.rule(keys, !uses_cma_es(spec.search.optimizer_or_usual()),
                  "search.start is given (only CMA-ES starts from a given "
                  "plant); leave it out, or use search.optimizer = \"auto\"");
    if (!problems.usable(keys)) return;
    std::size_t count = 0;
    for (const BredCrop& crop : bred_crops(spec, problems))
        count += check_start_of(
            crop, std::span(start).subspan(std::min(count, start.size())),
            problems);
    if (start.size() != count)
        problems.add(
            "search.start", ProblemCode::contradiction,
            "search.start has {} numbers (the traits that can be optimised "
            "have {}); use run --start PLANT, which writes them",
            start.size(), count);
}

}  // namespace

BaselineDoubts check_breeding(const Spec& spec, const Problems& problems) {
    BaselineDoubts doubts;
    const CropSpec& crop = spec.plant.crop;
    if (!crop.is_known) return doubts;
    for (std::size_t t = 0; t < crop.traits.size(); ++t)
        if (!is_sound(t, problems.in("plant.baseline"))) return doubts;
    check_constraints(spec, problems.in("constraints"));
    for (const BredCrop& bred : bred_crops(spec, problems)) {
        if (!bred.crop.is_known) continue;
        BaselineCheck check(bred);
        std::vector<Problem> outside = check.run();
        if (!outside.empty() && !bred.crop.rule.empty() && !bred.is_component())
            doubts.wider_bounds = check.wider_bounds();
        std::ranges::move(outside, std::back_inserter(doubts.outside));
    }
    check_start(spec, problems);
    return doubts;
}

}  // namespace ideotype
