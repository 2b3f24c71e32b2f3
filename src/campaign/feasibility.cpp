// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/crop/measures.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

Section trait_section(LineTrait& trait) {
    return {
        "feasibility.trait",
        {Key("measure", &trait.measure,
             "of plants that was measured of several lines")
             .set(&Key::is_any_text, true)
             .set(&Key::range, "measures of the plant")
             .required("\"leaf.insertion_angle\""),
         Key("leaf", &trait.leaf,
             "leaf whose measure it is, by its distance from the leaf at "
             "the ear or from the highest one")
             .set(&Key::is_any_text, true)
             .set(&Key::range, "\"ear\", \"ear+1\", \"top-1\", ...")
             .set(&Key::initial, "none: not of leaves"),
         Key("mean", &trait.mean, "of the lines, in the unit of the measure")
             .within(-1000, 1000)
             .required("20"),
         Key("deviation", &trait.deviation, "standard deviation of the lines")
             .within(1e-6, 1000)
             .required("5")}};
}

Section line_section(MeasuredLine& line) {
    return {
        "feasibility.line",
        {Key("name", &line.name, "of the line")
             .set(&Key::is_any_text, true)
             .set(&Key::range, "any text")
             .required("\"B73\""),
         Key("values", &line.values, "of the traits, in their order and units")
             .within(-1000, 1000)
             .required("[20, 0.8]")}};
}

}  // namespace

Section lines_section(MeasuredLines& known) {
    return {"feasibility",
            {Key("correlations", &known.correlations,
                 "of each pair of traits over the lines: of the first with all "
                 "later ones, then of the second with all later ones, ...")
                 .within(-1, 1)
                 .set(&Key::initial, "none: one trait")}};
}

std::vector<Table> lines_tables(MeasuredLines& known) {
    std::vector<Table> tables{
        list_of_tables<LineTrait>("trait", trait_section, known.traits),
        list_of_tables<MeasuredLine>("line", line_section, known.lines)};
    for (Table& table : tables) table.is_optional = true;
    tables.front().most = 30;
    tables.back().most = most_entries;
    return tables;
}

Table feasibility_table(Draft& draft) {
    Section section = lines_section(draft.lines);
    section.keys.insert(
        section.keys.begin(),
        {Key("lines", {},
             "file of measured lines, relative to the campaign file; or its "
             "content as [[feasibility.trait]] and [[feasibility.line]]")
             .set(&Key::type, "path")
             .set(&Key::range, "-")
             .set(&Key::initial, "none"),
         Key("limit", &draft.campaign.feasibility.limit,
             "largest Mahalanobis distance from the mean of the lines that is "
             "allowed; 0: any")
             .within(0, 1000)});
    Table table = one_table(section);
    table.children = lines_tables(draft.lines);
    table.is_optional = true;
    table.is_default = draft.lines.traits.empty();
    return table;
}

void check_feasibility(Draft& draft, Problems& problems) {
    const MeasuredLines& known = draft.lines;
    const std::size_t count = known.traits.size();
    for (const LineTrait& trait : known.traits) {
        const auto measure =
            find_measure(draft.campaign.crop.baseline, trait.measure);
        if (!measure)
            problems.add(
                &trait.measure,
                fmt::format("feasibility.trait: the plant has no {} "
                            "(which was measured of the lines); remove "
                            "it, or take a crop that has it",
                            trait.measure));
        else if (measure->is_of_leaves != names_leaf(trait.leaf))
            problems.add(
                &trait.leaf,
                fmt::format("feasibility.trait: leaf is \"{}\" ({} is "
                            "{} of leaves); {}",
                            trait.leaf, trait.measure,
                            measure->is_of_leaves ? "a measure" : "none",
                            measure->is_of_leaves
                                ? "write for example leaf = \"ear+1\""
                                : "remove it"));
    }
    for (const MeasuredLine& line : known.lines)
        if (line.values.size() != count)
            problems.add(
                &line.values,
                fmt::format("feasibility.line has {} values (there are "
                            "{} traits); give one for each",
                            line.values.size(), count));
    const std::size_t pairs = count < 2 ? 0 : count * (count - 1) / 2;
    if (known.correlations.size() != pairs)
        problems.add(
            &known.correlations,
            fmt::format("feasibility.correlations has {} numbers ({} "
                        "traits have {} pairs); give one for each pair",
                        known.correlations.size(), count, pairs));
    else if (!are_correlations(known))
        problems.add(
            &known.correlations,
            "feasibility.correlations are those of no numbers (their "
            "matrix is not positive definite); check them, or leave out "
            "a trait that follows from others");
    else if (problems.empty() && count > 0)
        draft.campaign.feasibility.lines = known;
    if (count == 0 && draft.campaign.feasibility.limit > 0)
        problems.add(&draft.campaign.feasibility.limit,
                     "feasibility.limit has no lines (a distance needs them); "
                     "add lines = \"FILE.toml\"");
    for (const ObjectiveEntry& objective : objectives_of(draft.campaign))
        if (is_of_lines(objective.quantity) && count == 0)
            problems.add(
                &draft.campaign.maximised,
                fmt::format("objective: {} is a distance from measured "
                            "lines (which there are not); add "
                            "[feasibility] with lines = \"FILE.toml\"",
                            objective.name));
}

}  // namespace ideotype
