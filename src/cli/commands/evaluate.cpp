// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/choose_row.hpp"
#include "cli/commands.hpp"
#include "cli/formats/light_output.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/host.hpp"
#include "ideotype/light/device.hpp"
#include "run/progress.hpp"
#include "spec/problems.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

//! Returns the objectives of a report. The standard error of a land equivalent
//! ratio includes the standard errors of sole crops.
std::vector<Measured> objectives_of(const CanopyReport& report,
                                    const Campaign& campaign) {
    std::vector<Measured> objectives;
    for (const ObjectiveEntry& objective : objectives_of(campaign))
        objectives.push_back(
            {{(campaign.spec.objective.sole.empty()
                   ? ""
                   : "land equivalent ratio of ") +
                  ((campaign.spec.objective.weights.empty() ? ""
                                                            : "weighted ") +
                   objective.name),
              unit_of(campaign, objective.quantity), ""},
             campaign.spec.objective.sole.empty()
                 ? measure_number(campaign, objective.name, report).estimate
                 : land_equivalent_ratio(campaign, report)});
    return objectives;
}

bool same_bits(const std::vector<Estimate>& a, const std::vector<Estimate>& b) {
    const auto bits = [](const Estimate& x) {
        return std::pair(std::bit_cast<std::uint64_t>(x.mean),
                         std::bit_cast<std::uint64_t>(x.standard_error));
    };
    return std::ranges::equal(a, b, {}, bits, bits);
}

//! Returns whether an outcome reproduces all stored numbers of a row bit for
//! bit. A file of an older format may lack quantities, or contain quantities
//! that no longer exist.
bool agrees_with(const ChosenRow& which, const Outcome& again) {
    const OutcomeSchema now = outcome_schema(which.campaign, which.chosen, {});
    const Outcome& was = which.row.outcome;
    if (was.status != Status::done ||
        !same_bits(again.objectives, was.objectives))
        return false;
    const auto values = [](const OutcomeSchema& schema, const Outcome& outcome,
                           const Quantity& quantity) {
        const auto first =
            outcome.quantities.begin() +
            static_cast<std::ptrdiff_t>(schema.measured.offset(quantity.name));
        return std::vector<Estimate>(
            first, first + static_cast<std::ptrdiff_t>(
                               schema.measured.size(quantity)));
    };
    for (const Quantity& quantity : now.measured.quantities)
        if (which.schema.measured.has(quantity.name) &&
            !same_bits(values(now, again, quantity),
                       values(which.schema, was, quantity)))
            return false;
    return true;
}

//! The results of a plant in one scenario of its case.
struct Study {
    Case scenario;
    CanopyReport report;
    std::vector<Measured> objectives;
    double seconds;  //!< time of all threads together
    QuantitySet measured;
};

//! Returns whether a quantity is that of a whole season.
bool is_of_season(const std::string& quantity) {
    return is_of_soil(quantity) || is_of_grain(quantity);
}

//! Adds the names of categories to categorical quantities, which are numbers.
void add_names(const QuantitySet& measured, Json& quantities) {
    for (const Quantity& quantity : measured.quantities) {
        if (quantity.names.empty() || !quantities.contains(quantity.name))
            continue;
        Json& number = quantities[quantity.name];
        const auto place = number["mean"].get<std::size_t>();
        if (place >= 1 && place <= quantity.names.size())
            number["name"] = quantity.names[place - 1];
    }
}

Json to_json(const Study& study) {
    Json json{{"case", study.scenario.name}};
    if (study.scenario.stage) json["stage"] = study.scenario.stage->at;
    json.update(to_json(study.report, Span::day));
    // A stage has only its part of the soil and the grain of a season.
    Json& quantities = json["quantities"];
    for (const Quantity& each : study.measured.quantities)
        if (is_of_season(each.name)) quantities.erase(each.name);
    add_names(study.measured, quantities);
    json.update(parts_json(study.report));
    for (const auto& [quantity, estimate] : study.objectives) {
        json["objectives"][quantity.name] = to_json(estimate);
        json["objectives"][quantity.name]["unit"] = quantity.unit;
    }
    json["seconds"] = study.seconds;
    return json;
}

std::vector<Study> studies(const Task& task, const Campaign& campaign,
                           const Case& chosen, const Plants& plants,
                           const std::string& isa) {
    std::vector<Study> results;
    Stand(campaign, chosen)
        .report_each(
            plants, sampling_of(task, campaign, chosen), Device(isa),
            [&](const Case& scenario, CanopyReport report) {
                std::vector<Measured> objectives =
                    objectives_of(report, campaign);
                const double seconds = report.seconds.total();
                results.push_back(
                    {scenario, std::move(report), std::move(objectives),
                     seconds, outcome_schema(campaign, scenario, {}).measured});
            },
            {.sunlit = true, .threads = available_cores(), .clock = now});
    return results;
}

Json to_json(const std::vector<Study>& studies) {
    std::vector<Json> list;
    for (const Study& study : studies) list.push_back(to_json(study));
    return list.size() == 1 ? list.front() : Json{{"scenarios", list}};
}

//! Arranges a study for printing: scalars, each objective once, quantities and,
//! in a separate part, the numbers that describe the method.
Json outline(const Json& study) {
    Json quantities = Json::object(), method = Json::object();
    const std::vector<std::string> names = objective_names();
    for (const auto& [name, value] : study["quantities"].items()) {
        if (study["objectives"].contains(name)) continue;
        const bool is_of_method =
            !value.contains("name") && std::ranges::count(names, name) == 0;
        (is_of_method ? method : quantities)[name] = value;
    }
    method["seconds"] = study["seconds"];
    Json numbers = Json::object(), parts = Json::object();
    for (const auto& [name, value] : study.items())
        (value.is_structured() && !value.contains("mean") ? parts
                                                          : numbers)[name] =
            value;
    for (const char* name : {"seconds", "balance_error"}) numbers.erase(name);
    numbers["objectives"] = study["objectives"];
    numbers["quantities"] = std::move(quantities);
    numbers["method"] = std::move(method);
    for (const auto& [name, value] : parts.items())
        if (!numbers.contains(name)) numbers[name] = value;
    return numbers;
}

//! Prints the results that fit on a screen. If `is_all`, also prints profiles
//! by leaf, layer and hour, which are otherwise only named.
void print_studies(const std::vector<Study>& studies, bool is_all) {
    for (const Study& study : studies) {
        if (&study != &studies.front()) fmt::print("\n");
        Json json = outline(to_json(study));
        std::vector<std::string> left;
        for (const auto& [name, value] : json.items())
            if (!is_all && value.is_structured() && !value.empty() &&
                !value.contains("mean") && name != "quantities" &&
                name != "objectives" && name != "method")
                left.push_back(name);
        for (const std::string& name : left) json.erase(name);
        print_outline(json);
        if (!left.empty())
            fmt::print("\n--all also prints {}\n", fmt::join(left, ", "));
    }
}

//! Returns the outcome of a row as a history stores it.
Outcome outcome_of(const Campaign& campaign, const Case& chosen,
                   const Plant& plant, const std::vector<Study>& studies) {
    std::vector<Outcome> outcomes;
    for (const Study& study : studies)
        outcomes.push_back(
            to_outcome(campaign, study.scenario, plant, study.report));
    return AcrossScenarios(campaign, chosen).combine(outcomes);
}

//! If plants grow, returns the objectives and the numbers of soil and grain
//! over all stages and scenarios, else an empty object.
Json season_of(const Campaign& campaign, const Case& chosen,
               const std::vector<Study>& studies) {
    Json season;
    if (evaluated_cases(chosen).size() == scenarios(chosen).size())
        return season;
    const Outcome outcome =
        outcome_of(campaign, chosen, campaign.crop.baseline, studies);
    const std::vector<ObjectiveEntry> objectives = objectives_of(campaign);
    for (std::size_t k = 0; k < objectives.size(); ++k) {
        Json& one = season[objectives[k].name] = to_json(outcome.objectives[k]);
        one["unit"] = unit_of(campaign, objectives[k]);
    }
    const AcrossScenarios across(campaign, chosen);
    for (const Quantity& each : across.measured().quantities) {
        if (!each.axes.empty() || !is_of_season(each.name)) continue;
        Json& one = season[each.name] =
            to_json(outcome.quantities.at(across.measured().offset(each.name)));
        one["unit"] = each.unit;
    }
    return season;
}

ExitCode evaluate_baseline(const EvaluateOptions& options) {
    const Campaign campaign = read_campaign(options.path, options.settings);
    const Case chosen = case_at(campaign, options.case_index, options.path);
    Task task;
    task.case_index = static_cast<std::uint32_t>(chosen.index);
    task.is_final = true;
    const std::vector<Study> results =
        studies(task, campaign, chosen, {campaign.crop.baseline},
                Device::supported_isas().back());
    const Json season = season_of(campaign, chosen, results);
    if (options.is_json) {
        Json json = to_json(results);
        if (!season.empty()) json["season"] = season;
        fmt::print("{}\n", to_text(json));
    } else {
        print_studies(results, options.is_all);
        for (const auto& [name, estimate] : season.items())
            fmt::print("season: {} {}\n", name, text_of(estimate));
    }
    return ExitCode::ok;
}

std::string name_of(const Task& task) {
    return task.is_final ? fmt::format("final slot {}", task.slot)
                         : fmt::format("generation {} slot {}", task.generation,
                                       task.slot);
}

//! Recomputes a row and compares it bit for bit with the history.
ExitCode repeat_row(const ChosenRow& which, const EvaluateOptions& options) {
    const auto& [campaign, chosen, task, row, keys, schema, isa] = which;
    const Plants plants = grow(campaign, row.candidate.genome);
    const std::vector<Study> results =
        studies(task, campaign, chosen, plants, isa);
    const Outcome again = outcome_of(campaign, chosen, plants.front(), results);
    const bool is_done = row.outcome.status == Status::done;
    const bool agrees = agrees_with(which, again);
    if (options.is_json) {
        Json json = to_json(results);
        json["row"] = {{"is_final", task.is_final},
                       {"generation", task.generation},
                       {"slot", task.slot},
                       {"is_done", is_done},
                       {"agrees_bit_for_bit", agrees}};
        fmt::print("{}\n", to_text(json));
    } else {
        print_studies(results, options.is_all);
        fmt::print("\n{}: {}\n", name_of(task),
                   agrees    ? "agrees bit for bit with the history"
                   : is_done ? "DIFFERS from the history"
                             : "has no result in the history to compare with");
    }
    return agrees || !is_done ? ExitCode::ok : ExitCode::runtime;
}

}  // namespace

ExitCode evaluate(const EvaluateOptions& options) {
    if (is_history(options.path) && !options.settings.empty())
        throw wrong_usage(
            "evaluate: --set applies to campaigns only (a row of a history is "
            "evaluated as recorded); leave it out");
    return is_history(options.path)
               ? repeat_row(choose_row(options.path, options.row), options)
               : evaluate_baseline(options);
}

}  // namespace ideotype
