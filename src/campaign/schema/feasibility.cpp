// SPDX-License-Identifier: Apache-2.0
#include "campaign/checks/checks.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/crop/measures.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

Section line_trait_section(LineTrait& trait) {
    Section section("feasibility.trait", {{"measure", &trait.measure},
                                          {"leaf", &trait.leaf},
                                          {"mean", &trait.mean},
                                          {"deviation", &trait.deviation}});
    for (const char* key : {"measure", "leaf"}) section[key].is_any_text = true;
    return section;
}

Section line_section(MeasuredLine& line) {
    return {"feasibility.line",
            {{"name", &line.name}, {"values", &line.values}}};
}

}  // namespace

Section lines_section(MeasuredLines& known) {
    return {"feasibility", {{"correlations", &known.correlations}}};
}

std::vector<Table> lines_tables(MeasuredLines& known) {
    return {list_of_tables("trait", line_trait_section, known.traits)
                .optional()
                .at_most(30),
            list_of_tables("line", line_section, known.lines)
                .optional()
                .at_most(most_entries)};
}

Table feasibility_table(Draft& draft) {
    Table table = one_table({"feasibility",
                             {{"lines", {}},
                              {"limit", &draft.campaign.feasibility.limit},
                              {"correlations", &draft.lines.correlations}}});
    table.children = lines_tables(draft.lines);
    return table.optional().left_out_if(draft.lines.traits.empty());
}

void check_feasibility(Draft& draft, const Problems& root) {
    const Problems problems = root.in("feasibility");
    const MeasuredLines& known = draft.lines;
    const std::size_t count = known.traits.size();
    for (std::size_t t = 0; t < count; ++t) {
        const LineTrait& trait = known.traits[t];
        const Problems own = problems.in("trait", t);
        const auto measure =
            find_measure(draft.campaign.crop.baseline, trait.measure);
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
    else if (problems.empty() && count > 0)
        draft.campaign.feasibility.lines = known;
    if (count == 0 && draft.campaign.feasibility.limit > 0)
        problems.add(
            "limit",
            "feasibility.limit is given (it bounds the distance from measured "
            "lines, and there are none); add lines = \"FILE.toml\"");
}

}  // namespace ideotype
