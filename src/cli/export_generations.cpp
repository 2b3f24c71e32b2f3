#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <fmt/os.h>

#include "ideotype/cli/verbs.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

namespace {

//! "MJ m-2 day-1" as the end of a column's name: "_MJ_per_m2_per_day".
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

//! Whether a diagnostic is one number of a plant: profiles by leaf, layer and
//! hour are in the history.
bool is_scalar(const std::string& name) {
    for (const char* profile : {"_leaf", "_layer_", "_hour_"}) {
        const std::size_t at = name.find(profile);
        if (at != std::string::npos &&
            std::isdigit(static_cast<unsigned char>(
                name[std::min(at + std::strlen(profile), name.size())])))
            return false;
    }
    return true;
}

const char* origin_name(Origin origin) {
    constexpr std::array names{"none", "baseline", "random", "elite", "child"};
    return names.at(static_cast<std::size_t>(origin));
}

void write_head(fmt::ostream& out, const HistoryHeader& header) {
    out.print("generation,slot,status,origin,parent_1,parent_2,fitness{}",
              suffix(header.schema.objectives.front().unit));
    const auto print = [&](const std::vector<Quantity>& quantities) {
        for (const auto& [name, unit] : quantities)
            if (is_scalar(name))
                out.print(",{0}{1},{0}_standard_error{1}", name, suffix(unit));
    };
    print(header.schema.objectives);
    print(header.schema.diagnostics);
    for (const Gene& gene : header.genes)
        out.print(",{}{}", gene.name, suffix(gene.unit));
    out.print("\n");
}

void write_estimates(fmt::ostream& out, const std::vector<Quantity>& quantities,
                     const std::vector<Estimate>& estimates) {
    for (std::size_t i = 0; i < quantities.size(); ++i)
        if (is_scalar(quantities[i].name))
            out.print(",{},{}", estimates[i].mean, estimates[i].standard_error);
}

void write_rows(fmt::ostream& out, std::uint32_t generation,
                const OutcomeSchema& schema, const std::vector<Row>& rows) {
    for (std::size_t slot = 0; slot < rows.size(); ++slot) {
        const auto& [candidate, outcome, fitness, attempt] = rows[slot];
        // The shortest digits that give the same number again.
        out.print("{},{},{},{},{},{},{}", generation, slot,
                  outcome.status == Status::done ? "done" : "failed",
                  origin_name(candidate.origin), candidate.parents[0],
                  candidate.parents[1], fitness);
        write_estimates(out, schema.objectives, outcome.objectives);
        write_estimates(out, schema.diagnostics, outcome.diagnostics);
        for (const double gene : candidate.genome) out.print(",{}", gene);
        out.print("\n");
    }
}

}  // namespace

ExitCode export_generations(const ExportOptions& options) {
    if (std::filesystem::path(options.to).extension() != ".csv")
        throw Error(options.to + ": generations are written as .csv",
                    ExitCode::usage);
    if (std::filesystem::exists(options.to))
        throw Error(options.to + ": exists already and is not overwritten",
                    ExitCode::refused);
    const History history = History::salvage(options.path);
    const std::uint32_t count = history.next_generation();
    if (count == 0)
        throw Error(options.path + ": no complete generation can be read");
    auto out = fmt::output_file(options.to);
    write_head(out, history.header());
    for (std::uint32_t g = 0; g < count; ++g)
        write_rows(out, g, history.header().schema, history.rows(g));
    out.close();
    if (history.missing_bytes() > 0)
        fmt::print(stderr,
                   "{}: {} bytes are missing at its end; {} of {} complete "
                   "generations are left\n",
                   options.path, history.missing_bytes(), count,
                   history.summaries().size());
    fmt::print("{}: {} generations\n", options.to, count);
    return ExitCode::ok;
}

}  // namespace ideotype
