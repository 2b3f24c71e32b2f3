#include <filesystem>

#include <fmt/format.h>
#include <fmt/os.h>

#include "ideotype/app/verbs.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

namespace {

void write_head(fmt::ostream& out, const HistoryHeader& header) {
    const Quantity& objective = header.schema.objectives.front();
    out.print(
        "generation,slot,status,parent_1,parent_2,{0} [{1}],"
        "standard_error [{1}]",
        objective.name, objective.unit);
    for (const Gene& gene : header.genes)
        out.print(",{} [{}]", gene.name, gene.unit);
    out.print("\n");
}

void write_rows(fmt::ostream& out, std::uint32_t generation,
                const Population& population) {
    for (std::size_t slot = 0; slot < population.size(); ++slot) {
        const Individual& one = population[slot];
        out.print("{},{},{},{},{},{},{}", generation, slot,
                  one.status == Status::done ? "done" : "failed",
                  one.candidate.parents[0], one.candidate.parents[1],
                  one.fitness, one.standard_error);
        // The shortest digits that give the same number again.
        for (const double gene : one.candidate.genome) out.print(",{}", gene);
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
        write_rows(out, g, history.generation(g));
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
