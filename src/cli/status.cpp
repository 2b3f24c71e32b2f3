// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "history/history.hpp"
#include "ideotype/core/text.hpp"
#include "json.hpp"
#include "run/progress.hpp"
#include "run/summary.hpp"
#include "run/way_on.hpp"
#include "verbs.hpp"

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
//! in full, or is no start of this program.
std::string way_on_with(const History& history) {
    const auto last = history.last_session();
    if (!last || last->command.size() >= longest_command ||
        !is_start(last->command))
        return "";
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

    //! A gain has been told that one search alone has found.
    void note_one_seed() { is_of_one_seed_ = true; }

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
        if (is_of_one_seed_) fmt::print("{}\n", one_seed);
        if (commands_.empty()) return;
        fmt::print("go on with\n");
        for (const std::string& command : commands_)
            fmt::print("  {}\n", command);
    }

    const std::vector<std::string>& commands() const { return commands_; }

  private:
    bool contains(const std::string& command) const {
        return std::find(commands_.begin(), commands_.end(), command) !=
               commands_.end();
    }

    std::map<State, int> cases_;
    bool is_of_one_seed_ = false;
    double rate_ = 0;                    //!< of what runs [evaluations/s]
    std::vector<std::string> commands_;  //!< cases of one job share one
};

//! What is told of a case; not all of it is known of each.
struct Report {
    std::string path, case_name, state;
    ExitCode code = ExitCode::ok;
    std::uint64_t missing_bytes = 0;
    std::optional<std::string> reason;  //!< of the end
    double complete = 0, generations = 0, evaluations = 0, failures = 0;
    std::size_t finalists = 0, failed_finalists = 0;
    std::string objective, unit;
    std::optional<Estimate> best, hypervolume;
    bool is_evaluated_again = false;
    double violation = 0;              //!< of the best
    std::string doubt;                 //!< of the leaf area of the best
    std::optional<double> rate, left;  //!< [evaluations/s], [s]
};

//! Of the final evaluation, or of the last generation.
void add_best(const History& history, Report& report) {
    const Objective& objective = history.header().schema.objectives.front();
    report.objective = objective.name;
    report.unit = objective.unit;
    const std::vector<Row> finalists = history.finalists();
    report.finalists = finalists.size();
    report.failed_finalists = failed_finalists(finalists);
    const std::size_t slot = best_finalist(finalists, objective.sense);
    report.is_evaluated_again = slot > 0 && history.finished();
    const auto take = [&](const Outcome& outcome) {
        report.violation = outcome.violation;
        if (const auto lai = find(history.header().schema, outcome, "lai"))
            report.doubt = doubt_of_lai(lai->mean);
    };
    if (report.is_evaluated_again) {
        report.best = finalists[slot].outcome.objectives.front();
        return take(finalists[slot].outcome);
    }
    const auto summaries = history.summaries();
    const GenerationSummary& last = summaries.back();
    const auto generation = static_cast<std::uint32_t>(summaries.size() - 1);
    report.best = {last.best, last.best_standard_error};
    take(history.row(generation, last.best_slot).outcome);
}

Report report_on(const std::string& path, Overview& overview) {
    const History history = History::salvage(path);
    const HistoryHeader& header = history.header();
    Report report;
    report.path = path;
    report.case_name = header.text.at("case");
    report.generations = header.generations;
    report.missing_bytes = history.missing_bytes();
    if (report.missing_bytes > 0) {
        report.state = "truncated";
        report.code = ExitCode::refused;
        report.complete = history.next_generation();
        report.generations = static_cast<double>(history.summaries().size());
        return report;
    }
    const Writer writer = writer_of(path);
    report.reason = history.finished();
    const State state = state_of(writer, report.reason);
    report.state = name_of(state);
    const auto summaries = history.summaries();
    report.complete = static_cast<double>(summaries.size());
    for (const GenerationSummary& s : summaries) {
        report.failures += s.failures;
        report.evaluations += s.evaluations;
    }
    const double wall_time = summaries.empty() ? 0 : summaries.back().wall_time;
    if (wall_time > 0) report.rate = report.evaluations / wall_time;
    const bool is_stopped = state == State::drained || state == State::dead;
    overview.add(state, report.rate.value_or(0),
                 is_stopped ? way_on_with(history) : "");
    if (summaries.empty()) return report;
    add_best(history, report);
    if (report.is_evaluated_again &&
        header.campaign_resolved.find("\nreplicates = 1\n") !=
            std::string::npos)
        overview.note_one_seed();
    const GenerationSummary& last = summaries.back();
    if (!std::isnan(last.hypervolume))
        report.hypervolume = {last.hypervolume,
                              last.hypervolume_standard_error};
    if (!report.reason)
        report.left = (report.generations - report.complete) * wall_time /
                      report.complete;
    return report;
}

std::string text_of_remains(const Report& report) {
    std::string line = fmt::format(
        "{}: truncated, {} bytes are missing at its end, {} of {} "
        "complete generations can be read; copy it again",
        report.path, report.missing_bytes, report.complete, report.generations);
    if (report.complete > 0)
        line += fmt::format(
            ", or save these with: ideotype export {} --generations --to "
            "NEW.csv",
            report.path);
    return line;
}

std::string to_text(const Report& report) {
    if (report.missing_bytes > 0) return text_of_remains(report);
    std::string line =
        fmt::format("{}: {}{}, {} of {} generations", report.path, report.state,
                    report.reason ? " by " + *report.reason : "",
                    report.complete, report.generations);
    if (report.best)
        line += fmt::format(
            ", best {} {} {}, {} failed", format(*report.best), report.unit,
            report.is_evaluated_again ? "(evaluated again)"
                                      : not_evaluated_again(report.violation),
            report.failures);
    if (!report.doubt.empty()) line += "; this plant " + report.doubt;
    if (report.failed_finalists > 0)
        line += fmt::format(", {} of {} finalists failed",
                            report.failed_finalists, report.finalists);
    if (report.hypervolume)
        line += fmt::format(", hypervolume {}", format(*report.hypervolume));
    if (report.rate)
        line += fmt::format(", {:.1f} evaluations/s", *report.rate);
    if (report.left)
        line += fmt::format(", {} left", format_duration(*report.left));
    return line;
}

//! null if there is none.
Json optional_json(const auto& value) {
    return value ? Json(*value) : Json();
}

Json to_json(const Report& report) {
    Json best;
    if (report.best) {
        best = {{"objective", report.objective}, {"unit", report.unit}};
        best.update(to_json(*report.best));
        best["violation"] = report.violation;
        best["is_evaluated_again"] = report.is_evaluated_again;
    }
    return {{"path", report.path},
            {"case", report.case_name},
            {"state", report.state},
            {"ended_by", optional_json(report.reason)},
            {"missing_bytes", report.missing_bytes},
            {"complete_generations", report.complete},
            {"generations", report.generations},
            {"evaluations", report.evaluations},
            {"failed", report.failures},
            {"finalists", report.finalists},
            {"failed_finalists", report.failed_finalists},
            {"best", best},
            {"hypervolume",
             report.hypervolume ? to_json(*report.hypervolume) : Json()},
            {"evaluations_per_second", optional_json(report.rate)},
            {"left_s", optional_json(report.left)}};
}

//! One file; adds it to the histories if these are told as JSON.
ExitCode show(const std::string& path, const StatusOptions& options,
              Overview& overview, Json& histories) {
    const Report report = report_on(path, overview);
    if (options.is_json)
        histories.push_back(to_json(report));
    else
        fmt::print("{}\n", printable(to_text(report)));
    return report.code;
}

}  // namespace

ExitCode status(const StatusOptions& options) {
    ExitCode worst = ExitCode::ok;
    Overview overview;
    Json json{{"histories", Json::array()}, {"unreadable", Json::array()}};
    for (const std::string& path : histories_in(options.paths)) try {
            worst = std::max(worst,
                             show(path, options, overview, json["histories"]));
        } catch (const Error& error) {
            // One unreadable file must not hide the others.
            fmt::print(stderr, "{}\n", printable_lines(error.what()));
            worst = std::max(worst, error.exit_code());
            json["unreadable"].push_back(
                {{"path", path}, {"message", error.what()}});
        }
    json["go_on_with"] = overview.commands();
    if (options.is_json)
        fmt::print("{}\n", to_text(json));
    else
        overview.print();
    return worst;
}

}  // namespace ideotype
