#include <fmt/format.h>

#include "ideotype/app/progress.hpp"
#include "ideotype/app/verbs.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

namespace {

std::string line_of(const std::string& path) {
    const History history = History::read(path);
    const HistoryHeader& header = history.header();
    const auto summaries = history.summaries();
    std::string line = fmt::format("{}: {} of {} generations", path,
                                   summaries.size(), header.generations);
    if (!summaries.empty()) {
        const GenerationSummary& last = summaries.back();
        std::uint32_t failures = 0;
        for (const GenerationSummary& s : summaries) failures += s.failures;
        line += fmt::format(", best {} {}, {} failed",
                            format({last.best, last.best_standard_error}),
                            header.schema.objectives.front().unit, failures);
    }
    const auto reason = history.finished();
    return line + (reason ? ", finished by " + *reason : ", not finished");
}

}  // namespace

ExitCode status(const StatusOptions& options) {
    ExitCode worst = ExitCode::ok;
    for (const std::string& path : options.paths) try {
            if (!options.only_resumable)
                fmt::print("{}\n", line_of(path));
            else if (!History::read(path).finished())
                fmt::print("{}\n", path);
        } catch (const Error& error) {
            // One unreadable file must not hide the others.
            fmt::print(stderr, "{}\n", error.what());
            worst = error.exit_code();
        }
    return worst;
}

}  // namespace ideotype
