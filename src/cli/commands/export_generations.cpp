// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/formats/output_file.hpp"
#include "history/history.hpp"
#include "spec/problems.hpp"

namespace ideotype {

namespace {

//! Converts a unit such as "MJ m-2 day-1" to a suffix of a column name,
//! "_MJ_per_m2_per_day".
std::string suffix(const std::string& unit) {
    std::istringstream factors(unit == "1" ? "" : unit);
    std::string text;
    for (std::string factor; factors >> factor;) {
        const std::size_t minus = factor.find('-');
        const std::string power =
            minus == std::string::npos ? "" : factor.substr(minus + 1);
        text += minus == std::string::npos ? "_" : "_per_";
        text += factor.substr(0, minus) + (power == "1" ? "" : power);
    }
    return text;
}

struct TableColumn {
    std::string name, unit;
    Certainty certainty;
    std::size_t place;  //!< index among the numbers of all quantities
};

//! Returns columns for scalars and for quantities along a single axis of names.
//! Profiles by leaf, layer and hour are left out; the history contains them.
std::vector<TableColumn> columns_of(const QuantitySet& measured) {
    std::vector<TableColumn> columns;
    for (const Quantity& quantity : measured.quantities) {
        const std::size_t first = measured.offset(quantity.name);
        const auto add = [&](const std::string& end, std::size_t i) {
            columns.push_back({quantity.name + end, suffix(quantity.unit),
                               quantity.certainty, first + i});
        };
        if (quantity.axes.empty()) {
            add("", 0);
        } else if (const auto* names = std::get_if<std::vector<std::string>>(
                       &measured.axis(quantity.axes[0]).coordinates);
                   names && quantity.axes.size() == 1) {
            for (std::size_t i = 0; i < names->size(); ++i)
                add('_' + (*names)[i], i);
        }
    }
    return columns;
}

void write_head(OutputFile& out, const HistoryHeader& header) {
    out.print("row,generation,slot,status,origin,parent_1,parent_2,violation");
    for (const auto& [name, unit, certainty, place] :
         columns_of(header.schema.measured)) {
        out.print(",{}{}", name, unit);
        if (certainty == Certainty::estimated)
            out.print(",{}_standard_error{}", name, unit);
    }
    for (const Gene& gene : header.genes)
        out.print(",{}{}", gene.name, suffix(gene.unit));
    out.print("\n");
}

void write_rows(OutputFile& out, std::uint64_t first, std::uint32_t generation,
                const std::vector<TableColumn>& columns,
                const std::vector<Row>& rows) {
    for (std::size_t slot = 0; slot < rows.size(); ++slot) {
        const auto& [candidate, outcome, attempt] = rows[slot];
        // Print numbers with the fewest digits that reproduce them exactly.
        out.print("{},{},{},{},{},{},{},{}", first + slot, generation, slot,
                  outcome.status == Status::done ? "done" : "failed",
                  name_of(candidate.origin), candidate.parents[0],
                  candidate.parents[1], outcome.violation);
        for (const TableColumn& column : columns) {
            const Estimate value = outcome.quantities.at(column.place);
            out.print(",{}", value.mean);
            if (column.certainty == Certainty::estimated)
                out.print(",{}", value.standard_error);
        }
        for (const double gene : candidate.genome) out.print(",{}", gene);
        out.print("\n");
    }
}

}  // namespace

ExitCode export_generations(const ExportOptions& options) {
    if (std::filesystem::path(options.to).extension() != ".csv")
        throw wrong_usage(
            "{}: generations are written as CSV; use a name that ends in .csv",
            options.to);
    require_new(options.to);
    const History history = History::salvage(options.path);
    const std::uint32_t count = history.next_generation();
    if (count == 0)
        throw Error(
            options.path +
            ": no complete generation can be read; there is nothing to export");
    OutputFile out(options.to);
    write_head(out, history.header());
    const auto columns = columns_of(history.header().schema.measured);
    std::uint64_t first = 0;
    for (std::uint32_t g = 0; g < count; first += history.size(g), ++g)
        write_rows(out, first, g, columns, history.rows(g));
    out.finish();
    if (history.missing_bytes() > 0)
        fmt::print(stderr,
                   "{}: {} bytes are missing at its end; {} of {} complete "
                   "generations can be read, and {} of these lack numbers and "
                   "cannot be verified by checksum\n",
                   options.path, history.missing_bytes(), count,
                   history.summaries().size(),
                   count - history.whole_generations());
    fmt::print("{}: {} generations\n", options.to, count);
    return ExitCode::ok;
}

}  // namespace ideotype
