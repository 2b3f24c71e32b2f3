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
        const Problems of_trait = problems.in("trait", t);
        const auto measure = find_measure(baseline, trait.measure);
        const bool is_of_leaves = measure && measure->is_of_leaves;
        of_trait.rule(
            ProblemCode::unknown_name, {"measure"}, !measure,
            "feasibility.trait names {} (which was measured on the lines, but "
            "this plant lacks it); remove it, or use a crop that has it",
            trait.measure);
        of_trait.rule(
            {"leaf", "measure"}, is_of_leaves != names_leaf(trait.leaf),
            "feasibility.trait: leaf is \"{}\" ({} is {} of leaves); {}",
            trait.leaf, trait.measure, is_of_leaves ? "a measure" : "none",
            is_of_leaves ? "write for example leaf = \"ear+1\"" : "remove it");
    }
    for (std::size_t l = 0; l < known.lines.size(); ++l)
        problems.in("line", l).rule({"values"},
                                    known.lines[l].values.size() != count,
                                    "feasibility.line has {} values (there are "
                                    "{} traits); give one for each",
                                    known.lines[l].values.size(), count);
    const std::size_t pairs = count < 2 ? 0 : count * (count - 1) / 2;
    problems.rule({"correlations"}, known.correlations.size() != pairs,
                  "feasibility.correlations has {} numbers ({} traits have {} "
                  "pairs); give one for each pair",
                  known.correlations.size(), count, pairs);
    problems.rule(
        {"correlations"}, [&] { return !are_correlations(known); },
        "feasibility.correlations are impossible (their matrix is not positive "
        "definite); check them, or leave out a trait that follows from others");
    problems.rule(
        {"limit"}, count == 0 && spec.feasibility.limit > 0,
        "feasibility.limit is given (it bounds the distance from measured "
        "lines, and there are none); add lines = \"FILE.toml\"");
}

}  // namespace ideotype
