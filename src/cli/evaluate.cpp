// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include <fmt/format.h>

#include "choose_row.hpp"
#include "ideotype/light/device.hpp"
#include "light_output.hpp"
#include "run/progress.hpp"
#include "run/summary.hpp"
#include "stand/stand.hpp"
#include "verbs.hpp"

namespace ideotype {

namespace {

Json to_json(const CanopyReport& report, const Case& chosen, double seconds) {
    Json json{{"case", chosen.name}};
    json.update(to_json(report, Span::day));
    json["seconds"] = seconds;
    return json;
}

void print_report(const CanopyReport& report, const Case& chosen,
                  double seconds) {
    fmt::print("case {}, {:.0f} ms\n", chosen.name, seconds * 1e3);
    print_light(report, Span::day);
    fmt::print("\nleaves absorb {}\n",
               format_daily(scaled(report.light.day.leaves, 1e-6)));
}

bool same_bits(const std::vector<Estimate>& a, const std::vector<Estimate>& b) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (bits(a[i].mean) != bits(b[i].mean) ||
            bits(a[i].standard_error) != bits(b[i].standard_error))
            return false;
    return true;
}

//! Whether all that is stored of a row is found again. An older format may
//! lack quantities, or have some that are computed no more.
bool agrees_with(const ChosenRow& which, const Outcome& again) {
    const OutcomeSchema now = outcome_schema(which.campaign, which.chosen, {});
    const Outcome& was = which.row.outcome;
    if (was.status != Status::done ||
        !same_bits(again.objectives, was.objectives))
        return false;
    const auto values = [](const OutcomeSchema& schema, const Outcome& outcome,
                           const Quantity& quantity) {
        const auto from =
            outcome.quantities.begin() +
            static_cast<std::ptrdiff_t>(schema.measured.offset(quantity.name));
        return std::vector<Estimate>(
            from,
            from + static_cast<std::ptrdiff_t>(schema.measured.size(quantity)));
    };
    for (const Quantity& each : now.measured.quantities)
        if (which.schema.measured.has(each.name) &&
            !same_bits(values(now, again, each),
                       values(which.schema, was, each)))
            return false;
    return true;
}

//! A plant in one scenario of its case.
struct Study {
    Case scenario;
    CanopyReport report;
    double seconds;
};

//! Of a plant in each scenario of a case.
//! @param accuracy that of the task without one
std::vector<Study> studies(const Task& task, const Campaign& campaign,
                           const Case& chosen, const Plant& plant,
                           const std::string& isa,
                           const std::optional<Accuracy>& accuracy = {}) {
    const Device device(isa);
    std::vector<Study> all;
    for (const Case& each : scenarios(chosen)) {
        CanopyRequest request =
            request_of(sampling_of(task, campaign, each), campaign,
                       scenario_of(campaign, each), plant);
        request.details.sunlit = true;
        if (accuracy) request.accuracy = *accuracy;
        const double began = now();
        CanopyReport report = evaluate(request, device);
        all.push_back({each, std::move(report), now() - began});
    }
    return all;
}

Json to_json(const std::vector<Study>& all) {
    std::vector<Json> each;
    for (const auto& [scenario, report, seconds] : all)
        each.push_back(to_json(report, scenario, seconds));
    return each.size() == 1 ? each.front() : Json{{"scenarios", each}};
}

void print_studies(const std::vector<Study>& all) {
    for (const auto& [scenario, report, seconds] : all) {
        if (&scenario != &all.front().scenario) fmt::print("\n");
        print_report(report, scenario, seconds);
    }
}

Plant plant_of(const ChosenRow& row) {
    return grow(row.campaign.crop, row.row.candidate.genome);
}

std::vector<Study> studies(const ChosenRow& row,
                           const std::optional<Accuracy>& accuracy = {}) {
    return studies(row.task, row.campaign, row.chosen, plant_of(row), row.isa,
                   accuracy);
}

//! What a row would have in its history.
Outcome outcome_of(const ChosenRow& row, const std::vector<Study>& all) {
    std::vector<Outcome> each;
    for (const Study& study : all)
        each.push_back(to_outcome(row.campaign, plant_of(row), study.report));
    return each.size() == 1
               ? each.front()
               : AcrossScenarios(row.campaign, row.chosen).combine(each);
}

ExitCode evaluate_baseline(const EvaluateOptions& options) {
    const Campaign campaign = read_campaign(options.path, options.settings);
    if (options.tolerance)
        throw Error(
            "evaluate: --tolerance is for rows of a history; that of a "
            "campaign is its light.tolerance",
            ExitCode::usage);
    const Case chosen = case_at(campaign, options.case_index, options.path);
    Task task;
    task.case_index = static_cast<std::uint32_t>(chosen.index);
    task.is_final = true;
    const std::vector<Study> all =
        studies(task, campaign, chosen, campaign.crop.baseline,
                Device::supported_isas().back());
    if (options.is_json)
        fmt::print("{}\n", to_text(to_json(all)));
    else
        print_studies(all);
    return ExitCode::ok;
}

std::string name_of(const Task& task) {
    return task.is_final ? fmt::format("final slot {}", task.slot)
                         : fmt::format("generation {} slot {}", task.generation,
                                       task.slot);
}

Json to_json(const Task& task, const Row& row) {
    return {{"is_final", task.is_final},
            {"generation", task.generation},
            {"slot", task.slot},
            {"is_done", row.outcome.status == Status::done}};
}

//! Recomputes a row, and compares every bit.
ExitCode repeat_row(const ChosenRow& which, bool is_json) {
    const auto& [campaign, chosen, task, row, schema, isa] = which;
    const std::vector<Study> all = studies(which);
    const Outcome again = outcome_of(which, all);
    const bool is_done = row.outcome.status == Status::done;
    const bool agrees = agrees_with(which, again);
    if (is_json) {
        Json json = to_json(all);
        json["row"] = to_json(task, row);
        json["row"]["agrees_bit_for_bit"] = agrees;
        fmt::print("{}\n", to_text(json));
    } else {
        print_studies(all);
        fmt::print("\n{}: {}\n", name_of(task),
                   agrees    ? "agrees bit for bit with the history"
                   : is_done ? "DIFFERS from the history"
                             : "has no result in the history to compare with");
    }
    return agrees || !is_done ? ExitCode::ok : ExitCode::runtime;
}

//! Evaluates a row in its own field with as many paths as a tolerance needs,
//! to tell what its error was.
ExitCode evaluate_row_again(const ChosenRow& which, double tolerance,
                            bool is_json) {
    const auto& [campaign, chosen, task, row, schema, isa] = which;
    if (task.is_final || row.outcome.status != Status::done)
        throw Error(
            fmt::format("evaluate: {} {}; --tolerance is for rows "
                        "that evolution evaluated",
                        name_of(task),
                        task.is_final ? "had many fields" : "has no result"),
            ExitCode::usage);
    constexpr int most_paths = 1 << 26;
    const std::vector<Study> all =
        studies(which, Accuracy{most_paths, 16, tolerance});
    const Estimate was = row.outcome.objectives.front();
    const Estimate is = outcome_of(which, all).objectives.front();
    const double deviation = (was.mean - is.mean) / was.standard_error;
    if (is_json) {
        Json json = to_json(all);
        json["row"] = to_json(task, row);
        json["row"].update({{"was", to_json(was)},
                            {"is", to_json(is)},
                            {"deviation_in_standard_errors", deviation}});
        fmt::print("{}\n", to_text(json));
    } else {
        print_studies(all);
        std::uint64_t paths = 0;
        for (const Study& study : all) paths += study.report.paths;
        fmt::print(
            "\n{}: {} in the history, {} with {} paths: {:.2f} of its "
            "standard errors off\n",
            name_of(task), format(was), format(is), paths, deviation);
    }
    return ExitCode::ok;
}

ExitCode evaluate_row(const EvaluateOptions& options) {
    const ChosenRow which = choose_row(options.path, options.row);
    return options.tolerance
               ? evaluate_row_again(which, *options.tolerance, options.is_json)
               : repeat_row(which, options.is_json);
}

}  // namespace

ExitCode evaluate(const EvaluateOptions& options) {
    if (is_history(options.path) && !options.settings.empty())
        throw Error(
            "evaluate: --set is for campaigns; a row of a history is "
            "evaluated as it was",
            ExitCode::usage);
    return is_history(options.path) ? evaluate_row(options)
                                    : evaluate_baseline(options);
}

}  // namespace ideotype
