// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.hpp"
#include "cli/formats/json.hpp"
#include "history/history.hpp"
#include "ideotype/core/text.hpp"
#include "run/job/way_on.hpp"
#include "run/progress.hpp"
#include "run/summary.hpp"
#include "spec/reader.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! Returns the given files, and all histories in the given folders.
std::vector<std::string> histories_in(const std::vector<std::string>& paths) {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        std::error_code unknown;  // ignored: opening the path reports it
        if (!fs::is_directory(path, unknown)) {
            files.push_back(path);
            continue;
        }
        std::vector<std::string> histories;
        for (const auto& entry : fs::recursive_directory_iterator(path))
            if (entry.path().extension() == ".h5" &&
                !entry.is_directory(unknown))
                histories.push_back(entry.path().string());
        if (histories.empty())
            throw Error(path + ": there is no history (*.h5) in this folder");
        std::sort(histories.begin(), histories.end());
        files.insert(files.end(), histories.begin(), histories.end());
    }
    return files;
}

//! Returns the state of a case. Read the state of the writer before the reason:
//! if a case ends between the two, it is then reported as finished, not as
//! drained.
std::string state_of(Writer writer, const std::optional<std::string>& reason) {
    if (reason) return "finished";
    if (writer == Writer::alive) return "running";
    return writer == Writer::closed ? "drained" : "dead";
}

//! Returns the command that resumes a case in the way it was last started.
//! Returns "" if that start was not fully recorded, or was made by another
//! program.
std::string way_on_with(const History& history) {
    const auto last = history.last_session();
    if (!last || last->command.size() >= longest_command ||
        !is_start(last->command))
        return "";
    return way_on(last->command, last->ranks);
}

struct CaseStatus {
    std::string path, case_name, state;
    std::uint64_t missing_bytes = 0;
    CaseResult result;
    std::optional<double> rate, left;  //!< rate [evaluations/s], time left [s]
    std::string way_on;                //!< command that resumes a stopped case
    bool has_launcher = false;  //!< whether this command begins with mpirun
    bool has_one_seed = false;
};

CaseStatus report_on(const std::string& path) {
    const History history = History::salvage(path);
    const HistoryHeader& header = history.header();
    CaseStatus report;
    report.path = path;
    report.case_name = header.text.at("case");
    report.missing_bytes = history.missing_bytes();
    if (report.missing_bytes > 0) {
        report.state = "truncated";
        report.result.complete = history.next_generation();
        report.result.generations =
            static_cast<double>(history.summaries().size());
        return report;
    }
    const Writer writer = find_writer(path);
    report.result = result_of(history);
    const CaseResult& result = report.result;
    report.state = state_of(writer, result.reason);
    if (!result.reason && writer != Writer::alive)
        report.way_on = way_on_with(history);
    report.has_launcher =
        !report.way_on.empty() && history.last_session()->ranks > 1;
    if (result.wall_time > 0)
        report.rate = result.evaluations / result.wall_time;
    if (!result.reason && result.plants > 0)
        report.left = (result.most_plants - result.plants) * result.wall_time /
                      result.plants;
    report.has_one_seed = result.is_evaluated_again && result.replicates == 1;
    return report;
}

std::string to_text(const CaseStatus& report) {
    const CaseResult& result = report.result;
    if (report.missing_bytes > 0)
        return fmt::format(
            "{}: truncated, {} bytes are missing at its end, {} of {} "
            "complete generations can be read; copy it again{}",
            report.path, report.missing_bytes, result.complete,
            result.generations,
            result.complete > 0
                ? fmt::format(", or save these with: ideotype export {} "
                              "--generations --to NEW.csv",
                              report.path)
                : "");
    std::string line = to_text(result, report.path, report.state);
    if (report.rate && !result.reason)
        line += fmt::format(", {:.1f} evaluations per second", *report.rate);
    if (report.left)
        line += fmt::format(", time left {}", format_duration(*report.left));
    return line;
}

Json optional_json(const auto& value) {
    return value ? Json(*value) : Json();
}

Json to_json(const CaseStatus& report) {
    const CaseResult& result = report.result;
    Json best;
    if (result.best) {
        best = {{"objective", result.objective}, {"unit", result.unit}};
        best.update(to_json(*result.best));
        best["violation"] = result.violation;
        best["is_evaluated_again"] = result.is_evaluated_again;
    }
    Json at_bounds = Json::array();
    for (const GeneAtBound& gene : result.at_bounds)
        at_bounds.push_back({{"gene", gene.gene},
                             {"bound", name_of(gene.bound)},
                             {"value", gene.value},
                             {"limit", gene.limit}});
    return {{"path", report.path},
            {"case", report.case_name},
            {"state", report.state},
            {"ended_by", optional_json(result.reason)},
            {"missing_bytes", report.missing_bytes},
            {"complete_generations", std::llround(result.complete)},
            {"generations", std::llround(result.generations)},
            {"evaluations", std::llround(result.evaluations)},
            {"plants", std::llround(result.plants)},
            {"most_plants", std::llround(result.most_plants)},
            {"failed", std::llround(result.failures)},
            {"finalists", result.finalists},
            {"failed_finalists", result.failed_finalists},
            {"best", best},
            {"at_bounds", at_bounds},
            {"hypervolume",
             result.hypervolume ? to_json(*result.hypervolume) : Json()},
            {"evaluations_per_second", optional_json(report.rate)},
            {"left_s", optional_json(report.left)}};
}

//! Prints totals over all files, and the commands that resume stopped cases.
void print_overview(const std::vector<CaseStatus>& reports,
                    const std::vector<std::string>& commands) {
    std::map<std::string, int> states;
    double rate = 0;  // rate of running cases [evaluations/s]
    for (const CaseStatus& report : reports) {
        ++states[report.state];
        if (report.state == "running") rate += report.rate.value_or(0);
    }
    if (reports.size() > 1) {
        std::vector<std::string> parts;
        for (const auto& [state, count] : states)
            parts.push_back(fmt::format("{} {}", count, state));
        fmt::print("{} cases: {}", reports.size(), fmt::join(parts, ", "));
        if (rate > 0) fmt::print("; {:.1f} evaluations per second", rate);
        fmt::print(
            "{}\n",
            reports.size() > lines_on_screen
                ? "; --json lists each case, ideotype summary prints gains"
                : "");
    }
    BoundCount bounds;
    for (const CaseStatus& each : reports) bounds.add(each.result.bounds);
    if (const std::string words = bounds.in_words(); !words.empty())
        fmt::print("{}\n", words);
    if (std::ranges::any_of(reports, &CaseStatus::has_one_seed))
        fmt::print("{}\n", one_seed);
    if (!commands.empty())
        fmt::print("resume with\n  {}\n", fmt::join(commands, "\n  "));
    if (std::ranges::any_of(reports, &CaseStatus::has_launcher))
        fmt::print(
            "(histories do not record options of mpirun, such as "
            "--oversubscribe; add those of the original command)\n");
}

}  // namespace

ExitCode status(const StatusOptions& options) {
    ExitCode worst = ExitCode::ok;
    std::vector<CaseStatus> reports;
    std::vector<std::string> commands;  // one for all cases of a job
    std::set<std::string> warnings;     // one for all cases with the same keys
    Json json{{"histories", Json::array()}, {"unreadable", Json::array()}};
    const std::vector<std::string> paths = histories_in(options.paths);
    for (const std::string& path : paths) try {
            const CaseStatus& report = reports.emplace_back(report_on(path));
            if (const auto& keys = report.result.passed_over; !keys.empty())
                warnings.insert(passed_over_text(keys));
            if (!report.way_on.empty() &&
                std::ranges::count(commands, report.way_on) == 0)
                commands.push_back(report.way_on);
            if (options.is_json)
                json["histories"].push_back(to_json(report));
            else if (report.state != "finished" ||
                     paths.size() <= lines_on_screen)
                fmt::print("{}\n", printable(to_text(report)));
            if (report.missing_bytes > 0)
                worst = std::max(worst, ExitCode::refused);
        } catch (const Error& error) {
            // An unreadable file must not prevent the report on others.
            fmt::print(stderr, "{}\n", printable_lines(error.what()));
            worst = std::max(worst, error.exit_code());
            json["unreadable"].push_back(
                {{"path", path}, {"message", error.what()}});
        }
    for (const std::string& warning : warnings)
        fmt::print(stderr, "ideotype: warning: {}\n", printable(warning));
    json["go_on_with"] = commands;
    if (options.is_json)
        fmt::print("{}\n", to_text(json));
    else
        print_overview(reports, commands);
    return worst;
}

ExitCode verify(const std::vector<std::string>& paths) {
    ExitCode worst = ExitCode::ok;
    for (const std::string& path : paths) try {
            const Verified verified = verify_file(path);
            fmt::print(
                "{}: header, {} generations and {} finalists match their "
                "checksums\n",
                path, verified.generations, verified.finalists);
        } catch (const Error& error) {
            // A damaged file must not prevent the report on others.
            fmt::print(stderr, "{}\n", printable_lines(error.what()));
            worst = std::max(worst, error.exit_code());
        }
    return worst;
}

}  // namespace ideotype
