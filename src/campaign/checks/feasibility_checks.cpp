// SPDX-License-Identifier: Apache-2.0
#include "campaign/checks/checks.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/crop/measures.hpp"
#include "spec/tables.hpp"

namespace ideotype {

void check_feasibility(const Spec& spec, const Problems& root) {
    const Problems problems = root.in("feasibility");
    const MeasuredLines& known = spec.feasibility.lines;
    Plant baseline = spec.plant.crop.baseline;
    const std::size_t count = known.traits.size();
    for (std::size_t t = 0; t < count; ++t) {
        const LineTrait& trait = known.traits[t];
        const Problems own = problems.in("trait", t);
        const auto measure = find_measure(baseline, trait.measure);
        if (!measure)
            own.add("measure",
                    "feasibility.trait names {} (which was measured on the "
                    "lines, but this plant does not have it); remove it, or "
                    "take a crop that has it",
                    trait.measure);
        else if (measure->is_of_leaves != names_leaf(trait.leaf))
            own.add("leaf",
                    "feasibility.trait: leaf is \"{}\" ({} is {} of leaves); "
                    "{}",
                    trait.leaf, trait.measure,
                    measure->is_of_leaves ? "a measure" : "none",
                    measure->is_of_leaves ? "write for example leaf = \"ear+1\""
                                          : "remove it");
    }
    for (std::size_t l = 0; l < known.lines.size(); ++l)
        if (known.lines[l].values.size() != count)
            problems.in("line", l).add(
                "values",
                "feasibility.line has {} values (there are {} traits); give "
                "one for each",
                known.lines[l].values.size(), count);
    const std::size_t pairs = count < 2 ? 0 : count * (count - 1) / 2;
    if (known.correlations.size() != pairs)
        problems.add("correlations",
                     "feasibility.correlations has {} numbers ({} traits have "
                     "{} pairs); give one for each pair",
                     known.correlations.size(), count, pairs);
    else if (!are_correlations(known))
        problems.add("correlations",
                     "feasibility.correlations are impossible (their matrix is "
                     "not positive definite); check them, or leave out a trait "
                     "that follows from others");
    if (count == 0 && spec.feasibility.limit > 0)
        problems.add(
            "limit",
            "feasibility.limit is given (it bounds the distance from measured "
            "lines, and there are none); add lines = \"FILE.toml\"");
}

}  // namespace ideotype
