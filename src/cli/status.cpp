// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "ideotype/cli/verbs.hpp"
#include "ideotype/history/history.hpp"
#include "ideotype/run/progress.hpp"
#include "ideotype/run/summary.hpp"
#include "ideotype/run/way_on.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! The files themselves, and for a folder all histories in it.
std::vector<std::string> histories_in(const std::vector<std::string>& paths) {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        std::error_code unknown;  // told when the path is opened
        if (!fs::is_directory(path, unknown)) {
            files.push_back(path);
            continue;
        }
        std::vector<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(path))
            if (entry.path().extension() == ".h5" &&
                !entry.is_directory(unknown))
                found.push_back(entry.path().string());
        if (found.empty())
            throw Error(path + ": there is no history (*.h5) in this folder");
        std::sort(found.begin(), found.end());
        files.insert(files.end(), found.begin(), found.end());
    }
    return files;
}

enum class State { finished, running, drained, dead };

//! The writer is to be looked at before the reason is read: a case that ends
//! in between is finished, not drained.
State state_of(Writer writer, const std::optional<std::string>& reason) {
    if (reason) return State::finished;
    switch (writer) {
        case Writer::alive:
            return State::running;
        case Writer::closed:
            return State::drained;
        case Writer::killed:
            break;
    }
    return State::dead;
}

std::string name_of(State state) {
    switch (state) {
        case State::finished:
            return "finished";
        case State::running:
            return "running";
        case State::drained:
            return "drained";
        case State::dead:
            break;
    }
    return "dead";
}

//! How the last start of a case would be repeated; empty if it is not known
//! in full.
std::string way_on_with(const History& history) {
    const auto last = history.last_session();
    if (!last || last->command.size() >= longest_command) return "";
    return way_on(last->command, last->ranks);
}

//! Sums over all files.
class Overview {
  public:
    void add(State state, double rate, const std::string& command) {
        ++cases_[state];
        if (state == State::running) rate_ += rate;
        if (!command.empty() && !contains(command))
            commands_.push_back(command);
    }

    void print() const {
        int count = 0;
        std::string states;
        for (const auto& [state, cases] : cases_) {
            count += cases;
            states += fmt::format("{}{} {}", states.empty() ? "" : ", ", cases,
                                  name_of(state));
        }
        if (count > 1) {
            fmt::print("{} cases: {}", count, states);
            if (rate_ > 0) fmt::print("; {:.1f} evaluations/s", rate_);
            fmt::print("\n");
        }
        if (commands_.empty()) return;
        fmt::print("go on with\n");
        for (const std::string& command : commands_)
            fmt::print("  {}\n", command);
    }

  private:
    bool contains(const std::string& command) const {
        return std::find(commands_.begin(), commands_.end(), command) !=
               commands_.end();
    }

    std::map<State, int> cases_;
    double rate_ = 0;                    //!< of what runs [evaluations/s]
    std::vector<std::string> commands_;  //!< cases of one job share one
};

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

//! Of the final evaluation, or of the last generation.
std::string best_of(const History& history) {
    const std::string unit = history.header().schema.objectives.front().unit;
    const std::vector<Row> finalists = history.finalists();
    const std::size_t slot = best_finalist(
        finalists, history.header().schema.objectives.front().sense);
    if (slot > 0 && history.finished())
        return fmt::format("{} {} (evaluated again)",
                           format(finalists[slot].outcome.objectives.front()),
                           unit);
    const auto summaries = history.summaries();
    const GenerationSummary& last = summaries.back();
    const auto generation = static_cast<std::uint32_t>(summaries.size() - 1);
    return fmt::format(
        "{} {} {}", format({last.best, last.best_standard_error}), unit,
        not_evaluated_again(
            history.row(generation, last.best_slot).outcome.violation));
}

Report report_on(const std::string& path, Overview& overview) {
    const History history = History::salvage(path);
    if (history.missing_bytes() > 0) return report_remains(path, history);
    const HistoryHeader& header = history.header();
    const Writer writer = writer_of(path);
    const auto reason = history.finished();
    const State state = state_of(writer, reason);
    const auto summaries = history.summaries();
    std::string line = fmt::format(
        "{}: {}{}, {} of {} generations", path, name_of(state),
        reason ? " by " + *reason : "", summaries.size(), header.generations);
    double failures = 0, evaluations = 0;
    for (const GenerationSummary& s : summaries) {
        failures += s.failures;
        evaluations += s.evaluations;
    }
    const double wall_time = summaries.empty() ? 0 : summaries.back().wall_time;
    const double rate = wall_time > 0 ? evaluations / wall_time : 0;
    const bool is_stopped = state == State::drained || state == State::dead;
    overview.add(state, rate, is_stopped ? way_on_with(history) : "");
    if (summaries.empty()) return {line};
    line += fmt::format(", best {}, {} failed", best_of(history), failures);
    const GenerationSummary& last = summaries.back();
    if (!std::isnan(last.hypervolume))
        line += fmt::format(
            ", hypervolume {}",
            format({last.hypervolume, last.hypervolume_standard_error}));
    if (rate > 0) line += fmt::format(", {:.1f} evaluations/s", rate);
    const double generations = static_cast<double>(summaries.size());
    if (!reason)
        line += fmt::format(", {} left",
                            format_duration((header.generations - generations) *
                                            wall_time / generations));
    return {line};
}

ExitCode show(const std::string& path, bool only_resumable,
              Overview& overview) {
    if (only_resumable) {
        if (!History::read(path).finished() && writer_of(path) != Writer::alive)
            fmt::print("{}\n", path);
        return ExitCode::ok;
    }
    const Report report = report_on(path, overview);
    fmt::print("{}\n", report.line);
    return report.code;
}

}  // namespace

ExitCode status(const StatusOptions& options) {
    ExitCode worst = ExitCode::ok;
    Overview overview;
    for (const std::string& path : histories_in(options.paths)) try {
            worst =
                std::max(worst, show(path, options.only_resumable, overview));
        } catch (const Error& error) {
            // One unreadable file must not hide the others.
            fmt::print(stderr, "{}\n", error.what());
            worst = std::max(worst, error.exit_code());
        }
    overview.print();
    return worst;
}

}  // namespace ideotype
