#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "ideotype/app/progress.hpp"
#include "ideotype/app/verbs.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! The files themselves, and for a folder all histories in it.
std::vector<std::string> histories_in(const std::vector<std::string>& paths) {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        if (!fs::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        std::vector<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(path))
            if (entry.path().extension() == ".h5")
                found.push_back(entry.path().string());
        if (found.empty())
            throw Error(path + ": there is no history (*.h5) in this folder");
        std::sort(found.begin(), found.end());
        files.insert(files.end(), found.begin(), found.end());
    }
    return files;
}

std::string state_of(const History& history, const std::string& path) {
    if (const auto reason = history.finished()) return "finished by " + *reason;
    switch (writer_of(path)) {
        case Writer::alive:
            return "running";
        case Writer::closed:
            return "drained";
        case Writer::killed:
            return "dead";
    }
    return "";
}

//! One line, and whether the file is whole.
struct Report {
    std::string line;
    ExitCode code = ExitCode::ok;
};

Report report_remains(const std::string& path, const History& history) {
    const std::uint32_t count = history.next_generation();
    std::string line = fmt::format(
        "{}: truncated, {} bytes are missing at its end, {} of {} "
        "complete generations can be read; copy it again",
        path, history.missing_bytes(), count, history.summaries().size());
    if (count > 0)
        line += fmt::format(
            ", or save these with: ideotype export {} --generations --to "
            "NEW.csv",
            path);
    return {line, ExitCode::refused};
}

Report report_on(const std::string& path) {
    const History history = History::salvage(path);
    if (history.missing_bytes() > 0) return report_remains(path, history);
    const HistoryHeader& header = history.header();
    const auto summaries = history.summaries();
    std::string line = fmt::format("{}: {}, {} of {} generations", path,
                                   state_of(history, path), summaries.size(),
                                   header.generations);
    if (summaries.empty()) return {line};
    const GenerationSummary& last = summaries.back();
    double failures = 0, evaluations = 0;
    for (const GenerationSummary& s : summaries) {
        failures += s.failures;
        evaluations += s.evaluations;
    }
    line += fmt::format(", best {} {}, {} failed",
                        format({last.best, last.best_standard_error}),
                        header.schema.objectives.front().unit, failures);
    const double generations = static_cast<double>(summaries.size());
    if (last.wall_time > 0)
        line +=
            fmt::format(", {:.1f} evaluations/s", evaluations / last.wall_time);
    if (!history.finished())
        line += fmt::format(", {} left",
                            format_duration((header.generations - generations) *
                                            last.wall_time / generations));
    return {line};
}

ExitCode show(const std::string& path, bool only_resumable) {
    if (only_resumable) {
        if (!History::read(path).finished() && writer_of(path) != Writer::alive)
            fmt::print("{}\n", path);
        return ExitCode::ok;
    }
    const Report report = report_on(path);
    fmt::print("{}\n", report.line);
    return report.code;
}

}  // namespace

ExitCode status(const StatusOptions& options) {
    ExitCode worst = ExitCode::ok;
    for (const std::string& path : histories_in(options.paths)) try {
            worst = std::max(worst, show(path, options.only_resumable));
        } catch (const Error& error) {
            // One unreadable file must not hide the others.
            fmt::print(stderr, "{}\n", error.what());
            worst = std::max(worst, error.exit_code());
        }
    return worst;
}

}  // namespace ideotype
