// SPDX-License-Identifier: Apache-2.0
#include "format_1.hpp"

#include <algorithm>
#include <cstdint>
#include <regex>

#include <fmt/format.h>

#include "columns.hpp"
#include "dataset.hpp"
#include "generations.hpp"
#include "header.hpp"
#include "journal.hpp"
#include "open.hpp"

namespace ideotype {

namespace {

// Was a quantity, and now is a part of every outcome.
constexpr auto violation_column = "violation";

std::vector<std::string> texts(hid_t file, const std::string& name) {
    const Dataset dataset(file, name);
    return dataset.read_text(0, dataset.rows());
}

template <class Value>
std::vector<Value> all(hid_t file, const std::string& name) {
    const Dataset dataset(file, name);
    return dataset.read<Value>(0, dataset.rows());
}

GeneSpace read_genes(hid_t file) {
    const auto names = texts(file, "traits/name");
    const auto units = texts(file, "traits/unit");
    const auto lower = all<double>(file, "traits/lower");
    const auto upper = all<double>(file, "traits/upper");
    const auto is_circular = all<std::int8_t>(file, "traits/is_circular");
    const auto is_free = all<std::int8_t>(file, "traits/is_free");
    static const std::regex form("leaf(\\d+)_(.+)");
    GeneSpace genes;
    for (std::size_t i = 0; i < names.size(); ++i) {
        Gene gene{
            names[i],       units[i], lower[i], upper[i], is_circular[i] != 0,
            is_free[i] != 0};
        if (std::smatch parts; std::regex_match(names[i], parts, form)) {
            gene.trait =
                parts[2] == "inclination" ? "insertion_angle" : parts[2].str();
            gene.leaf = std::stoi(parts[1]);
            gene.name = fmt::format("leaf{:02}_{}", gene.leaf, gene.trait);
        }
        genes.push_back(std::move(gene));
    }
    return genes;
}

// Where a column of diagnostics belongs.
struct Column {
    std::string name, unit;
    std::string quantity;
    std::string axis;  //!< none: a single number
    double place = 0;
    std::string label;  //!< in place of a number
};

// Profiles were columns of their own, which said by their names what they are.
Column column_of(const std::string& name, const std::string& unit) {
    static const std::regex leaf("(.+)_leaf(\\d+)");
    static const std::regex layer("(.+)_layer_(\\d+)_(\\d+)cm");
    static const std::regex hour("(.+)_hour_(\\d+)_(\\d+)");
    static const std::regex source("(absorbed)_(beam|sky|scattered)");
    static const std::regex side("(absorbed)_(adaxial|abaxial)");
    std::smatch parts;
    const auto number = [&](int i) { return std::stod(parts[i]); };
    const auto with = [&](const std::string& axis, double place,
                          const std::string& label = "") {
        return Column{name, unit,  parts[1].str() + "_by_" + axis,
                      axis, place, label};
    };
    if (std::regex_match(name, parts, leaf)) return with("leaf", number(2));
    if (std::regex_match(name, parts, layer))
        return with("layer", (number(2) + number(3)) / 200);
    if (std::regex_match(name, parts, hour))
        return with("hour", number(2) + number(3) / 60);
    if (std::regex_match(name, parts, source)) {
        Column column = with("source", 0, parts[2]);
        column.axis = "light_source";
        return column;
    }
    if (std::regex_match(name, parts, side)) {
        Column column = with("side", 0, parts[2]);
        column.axis = "leaf_side";
        return column;
    }
    return {name, unit, name, "", 0, ""};
}

std::vector<Column> read_columns(hid_t file) {
    const auto names = texts(file, "diagnostics/name");
    const auto units = texts(file, "diagnostics/unit");
    std::vector<Column> columns;
    for (std::size_t i = 0; i < names.size(); ++i)
        columns.push_back(column_of(names[i], units[i]));
    return columns;
}

void extend(Axis& axis, const Column& column) {
    if (column.label.empty())
        std::get<std::vector<double>>(axis.coordinates).push_back(column.place);
    else
        std::get<std::vector<std::string>>(axis.coordinates)
            .push_back(column.label);
}

// Neighbouring columns of one profile become one quantity with an axis.
QuantitySet measured_of(const std::vector<Column>& columns) {
    QuantitySet set;
    for (const Column& column : columns) {
        auto& quantities = set.quantities;
        if (column.name == violation_column) continue;
        if (quantities.empty() || quantities.back().name != column.quantity)
            quantities.push_back({column.quantity, column.unit, ""});
        if (column.axis.empty()) continue;
        quantities.back().axes = {column.axis};
        const bool is_first =
            std::none_of(set.axes.begin(), set.axes.end(),
                         [&](const Axis& a) { return a.name == column.axis; });
        if (is_first) {
            Axis axis{column.axis, "1", "", std::vector<double>{}};
            if (!column.label.empty()) {
                axis.unit = "";
                axis.coordinates = std::vector<std::string>{};
            }
            if (column.axis == "hour") axis.unit = "h";
            if (column.axis == "layer") axis.unit = "m";
            set.axes.push_back(std::move(axis));
        }
        for (Axis& axis : set.axes)
            if (axis.name == column.axis) extend(axis, column);
    }
    return set;
}

HistoryHeader read_old_header(hid_t file) {
    HistoryHeader header;
    read_attributes(file, header);
    header.text["upgraded_from"] = header.text["format_version"];
    for (const char* name : {"format", "format_version"})
        header.text.erase(name);
    header.campaign_source = texts(file, "campaign/source")[0];
    header.campaign_resolved = texts(file, "campaign/resolved")[0];
    header.genes = read_genes(file);
    const auto names = texts(file, "objectives/name");
    const auto units = texts(file, "objectives/unit");
    for (std::size_t i = 0; i < names.size(); ++i)
        header.schema.objectives.push_back({names[i], units[i]});
    header.schema.measured = measured_of(read_columns(file));
    return header;
}

// Rows of one of its tables, from first. Their parents were slots of a
// generation that begins at parents_row.
std::vector<Row> read_rows(hid_t file, const std::string& group,
                           const OutcomeSchema& schema, hsize_t first,
                           hsize_t count, hsize_t parents_row) {
    const auto column = [&](const char* name) {
        return Dataset(file, group + "/" + name);
    };
    const auto numbers = [&](const char* name) {
        return column(name).read<double>(first, count);
    };
    const auto status = column("status").read<Status>(first, count);
    const auto genome = numbers("genome");
    const auto origin = column("origin").read<Origin>(first, count);
    const auto parents = column("parents").read<std::int32_t>(first, count);
    const auto fitness = numbers("fitness");
    const auto objectives = numbers("objectives");
    const auto objectives_error = numbers("objectives_standard_error");
    const auto diagnostics = numbers("diagnostics");
    const auto diagnostics_error = numbers("diagnostics_standard_error");
    const auto attempt = column("attempt").read<std::uint32_t>(first, count);
    const auto seconds = numbers("seconds");
    const auto worker = column("worker").read<std::int32_t>(first, count);
    const auto message = column("message").read_text(first, count);
    const auto names = texts(file, "diagnostics/name");
    const std::size_t genes = count == 0 ? 0 : genome.size() / count;
    std::vector<Row> rows(count);
    for (std::size_t i = 0; i < count; ++i) {
        Row& row = rows[i];
        const auto gene =
            genome.begin() + static_cast<std::ptrdiff_t>(i * genes);
        row.candidate.genome.assign(gene,
                                    gene + static_cast<std::ptrdiff_t>(genes));
        row.candidate.origin = origin[i];
        // Version 0.1 stored slot 0 for those that have none.
        if (origin[i] == Origin::elite || origin[i] == Origin::child)
            for (std::size_t p = 0; p < 2; ++p)
                if (const std::int32_t slot = parents[2 * i + p]; slot >= 0)
                    row.candidate.parents[p] =
                        static_cast<std::int64_t>(parents_row) + slot;
        row.attempt = attempt[i];
        row.outcome = unknown_outcome(schema);
        row.outcome.status = status[i];
        row.outcome.seconds = seconds[i];
        row.outcome.worker = static_cast<std::uint32_t>(worker[i]);
        row.outcome.message = message[i];
        if (status[i] != Status::done) continue;
        // Minus the violation, where there is one; objectives were positive.
        row.outcome.violation = std::max(0.0, -fitness[i]);
        for (std::size_t j = 0; j < row.outcome.objectives.size(); ++j) {
            const std::size_t at = i * row.outcome.objectives.size() + j;
            row.outcome.objectives[j] = {objectives[at], objectives_error[at]};
        }
        auto target = row.outcome.quantities.begin();
        for (std::size_t j = 0; j < names.size(); ++j)
            if (names[j] != violation_column)
                *target++ = {diagnostics[i * names.size() + j],
                             diagnostics_error[i * names.size() + j]};
    }
    return rows;
}

void copy_rows(const std::vector<Row>& rows, Columns& columns, hsize_t first) {
    std::vector<Candidate> candidates;
    std::vector<Status> statuses;
    for (const Row& row : rows) {
        candidates.push_back(row.candidate);
        statuses.push_back(row.outcome.status);
    }
    columns.write(first, candidates);
    columns.write_outcomes(first, rows);
    columns.set_statuses(first, statuses);
}

void copy_generations(hid_t from, hid_t to, const HistoryHeader& header) {
    Columns columns(to, "evaluations", header.schema);
    Generations generations(to);
    const auto population = static_cast<hsize_t>(header.population);
    const auto committed = all<std::int8_t>(from, "generations/committed");
    const auto best_slot = all<std::uint32_t>(from, "generations/best_slot");
    const auto failures = all<std::uint32_t>(from, "generations/failures");
    const auto evaluations =
        all<std::uint32_t>(from, "generations/evaluations");
    const auto numbers = [&](const std::string& name) {
        return all<double>(from, "generations/" + name);
    };
    const auto best = numbers("best"), error = numbers("best_standard_error"),
               mean = numbers("mean"), spread = numbers("spread"),
               diversity = numbers("diversity"),
               wall_time = numbers("wall_time");
    for (std::uint32_t g = 0; g < committed.size(); ++g) {
        const Span span{g * population, population};
        const auto rows =
            read_rows(from, "evaluations", header.schema, span.first,
                      span.count, g == 0 ? 0 : span.first - population);
        if (rows[0].outcome.status == Status::empty) break;
        copy_rows(rows, columns, span.first);
        generations.set_span(g, span);
        if (committed[g] == 0) break;
        generations.write(g, {.best_slot = best_slot[g],
                              .best = best[g],
                              .best_standard_error = error[g],
                              .mean = mean[g],
                              .spread = spread[g],
                              .diversity = diversity[g],
                              .failures = failures[g],
                              .evaluations = evaluations[g],
                              .wall_time = wall_time[g]});
        generations.set_committed(g);
    }
    Columns finals(to, "final", header.final_schema());
    const std::uint32_t last = std::max(generations.committed(), 1U) - 1;
    copy_rows(read_rows(from, "final", header.final_schema(), 0, finals.rows(),
                        generations.span(last).first),
              finals, 0);
}

}  // namespace

Handle upgraded(hid_t old) {
    const HistoryHeader header = read_old_header(old);
    Handle file = create_in_memory(header);
    copy_generations(old, file, header);
    Journal journal(file);
    journal.set_wall_time(all<double>(old, "state/wall_time")[0]);
    if (all<std::int8_t>(old, "state/finished")[0] != 0) {
        journal.set_reason(texts(old, "state/reason")[0]);
        journal.set_finished();
    }
    return file;
}

}  // namespace ideotype
