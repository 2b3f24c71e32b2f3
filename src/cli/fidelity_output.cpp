// SPDX-License-Identifier: Apache-2.0
#include "fidelity_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/run/progress.hpp"

namespace ideotype {

namespace {

const char* name_of(Goal goal) {
    return goal == Goal::value ? "value" : "difference";
}

const char* name_of(Randomness::Fields fields) {
    return fields == Randomness::Fields::one ? "one" : "each";
}

//! "-0.123 +- 0.004", in per cent.
std::string percent(Estimate x) {
    return fmt::format("{:.3f} +- {:.3f}", 100 * x.mean,
                       100 * x.standard_error);
}

double milliseconds(double seconds) {
    return 1e3 * seconds;
}

//! Of one evaluation as the campaign samples, but for the value.
Combination evaluation(const Trade& trade, std::size_t parameter,
                       std::size_t value, Goal goal) {
    std::vector<std::size_t> values;
    for (const MeasuredParameter& each : trade.parameters)
        values.push_back(each.parameter.own);
    values[parameter] = value;
    Accuracy accuracy = trade.own.campaign.sampling;
    const MeasuredParameter& turned = trade.parameters[parameter];
    if (turned.parameter.kind == Parameter::Kind::paths)
        accuracy.paths = turned.parameter.at(value).campaign.sampling.paths;
    return combine(trade, values, accuracy, Randomness::Fields::one, goal);
}

std::string summary(const Combination& combination, const Campaign& campaign) {
    return fmt::format(
        "{:>7} x {:<3} {:>5} {:>6} {:>6} {:>6}", combination.accuracy.paths,
        combination.accuracy.randomisations,
        fmt::format("{}x{}", campaign.field.rows, campaign.field.plants),
        campaign.tessellation.cells_along, campaign.tessellation.stalk_sides,
        campaign.climates.empty() ? campaign.days[0].value.step_minutes
                                  : campaign.sun_dates);
}

//! The keys that a combination changes, as a part of a campaign file.
std::string keys_text(const Campaign& was, const Campaign& is) {
    const std::vector<PastedKey> before = keys_of(was);
    std::string text, section;
    for (const PastedKey& key : keys_of(is)) {
        const bool is_same = std::any_of(
            before.begin(), before.end(), [&](const PastedKey& other) {
                return other.section == key.section && other.name == key.name &&
                       other.value == key.value;
            });
        if (is_same) continue;
        if (key.section != section)
            text += fmt::format("[{}]\n", section = key.section);
        text += fmt::format("{} = {}\n", key.name, key.value);
    }
    return text;
}

Json to_json(const Inaccuracy& x) {
    return {{"bias", to_json(x.bias)},
            {"field_deviation", to_json(x.scatter.field)},
            {"path_deviation", to_json(x.scatter.path)}};
}

Json to_json(const Combination& combination, const Trade& trade) {
    Json json{
        {"milliseconds", milliseconds(combination.seconds())},
        {"error", combination.error()},
        {"bias", to_json(combination.bias)},
        {"standard_error", combination.standard_error},
        {"milliseconds_geometry", milliseconds(combination.cost.geometry)},
        {"milliseconds_scene", milliseconds(combination.cost.scene)},
        {"milliseconds_light", milliseconds(combination.cost.path)}};
    for (const PastedKey& key : keys_of(applied(trade, combination)))
        json["keys"][key.section == "[day]" ? "day" : key.section][key.name] =
            Json::parse(key.value);
    return json;
}

}  // namespace

void print_trade(const Trade& trade) {
    const Campaign& campaign = trade.own.campaign;
    fmt::print(
        "baseline: {} {} {}; the other plant {} more\n\n"
        "In % of that: bias against the converged value (>), and standard "
        "error of one\nevaluation with {} x {} paths in one field; ms of the "
        "processor (*: the campaign).\n\n{:<13} {:<22} {:>16} {:>6} {:>17} "
        "{:>6} {:>6} {:>6} {:>6} {:>6}\n",
        aims(campaign).front().quantity, format(trade.value),
        unit_of(aims(campaign).front().quantity), format(trade.difference),
        campaign.sampling.paths, campaign.sampling.randomisations, "parameter",
        "value", "bias", "s.e.", "bias of a diff.", "s.e.", "geom.", "scene",
        "light", "all");
    for (std::size_t k = 0; k < trade.parameters.size(); ++k) {
        const MeasuredParameter& each = trade.parameters[k];
        for (std::size_t v = 0; v < each.points.size(); ++v) {
            const ParameterPoint& point = each.points[v];
            const Combination value = evaluation(trade, k, v, Goal::value);
            const Combination difference =
                evaluation(trade, k, v, Goal::difference);
            const auto bias = [&](Goal goal) {
                return v == each.parameter.reference
                           ? ">"
                           : percent(point.of(goal).bias);
            };
            fmt::print(
                "{:<13} {:<22} {:>16} {:>6.3f} {:>17} {:>6.3f} {:>6.2f} "
                "{:>6.2f} {:>6.1f} {:>6.1f}\n",
                v == 0 ? each.parameter.name : "",
                point.name + (v == each.parameter.own ? " *" : ""),
                bias(Goal::value), 100 * value.standard_error,
                bias(Goal::difference), 100 * difference.standard_error,
                milliseconds(value.cost.geometry),
                milliseconds(value.cost.scene), milliseconds(value.cost.path),
                milliseconds(value.seconds()));
        }
    }
}

void print_choices(const Trade& trade, const std::vector<Choice>& choices,
                   double asked) {
    fmt::print(
        "\nThe cheapest for one evaluation, its error (root mean square of "
        "bias and standard\nerror) in %; fields: one for all randomisations, "
        "as generations have it, or one for\neach, as finalists have it. Last: "
        "as found by evaluating again.\n\n{:<10} {:>9} {:>6} {:>13} {:>5} "
        "{:>6} "
        "{:>6} {:>6} {:>7} {:>6} {:>6}  {}\n",
        "error of", "tolerance", "fields", "paths", "cell", "cells", "sides",
        trade.own.campaign.climates.empty() ? "step" : "dates", "error", "ms",
        "ms", "bias, s.e.");
    for (const Choice& choice : choices) {
        fmt::print("{:<10} {:>9.3f} {:>6} ", name_of(choice.goal),
                   100 * choice.tolerance, name_of(choice.fields));
        const Combination& found = choice.combination;
        fmt::print("{} {:>7.3f} {:>6.2f} ",
                   summary(found, applied(trade, found)), 100 * found.error(),
                   milliseconds(found.seconds()));
        if (choice.check)
            fmt::print("{:>6.2f}  {}, {}\n",
                       milliseconds(choice.check->seconds),
                       percent(choice.check->bias),
                       percent(choice.check->standard_error));
        else
            fmt::print("not met; the most accurate\n");
    }
    for (const Choice& choice : choices) {
        if (choice.tolerance != asked ||
            choice.fields != Randomness::Fields::one)
            continue;
        const std::string goal =
            fmt::format("{} to {:.3f} %", name_of(choice.goal), 100 * asked);
        const Combination& found = choice.combination;
        fmt::print(
            "\n# {}: change in the campaign\n{}",
            choice.is_met()
                ? goal
                : fmt::format("{} is not met (no setting is so accurate); the "
                              "most accurate, {:.3f} %",
                              goal, 100 * found.error()),
            keys_text(trade.own.campaign, applied(trade, found)));
    }
}

Json to_json(const Trade& trade, const std::vector<Choice>& choices) {
    const Campaign& campaign = trade.own.campaign;
    Json json{{"campaign", campaign.name},
              {"case", case_of(trade.own, trade.case_index).name},
              {"paths", campaign.sampling.paths},
              {"randomisations", campaign.sampling.randomisations},
              {"objective", aims(campaign).front().quantity},
              {"unit", unit_of(aims(campaign).front().quantity)},
              {"value", to_json(trade.value)},
              {"difference", to_json(trade.difference)}};
    for (std::size_t k = 0; k < trade.parameters.size(); ++k) {
        const MeasuredParameter& each = trade.parameters[k];
        Json parameter{{"name", each.parameter.name}};
        for (std::size_t v = 0; v < each.points.size(); ++v) {
            const ParameterPoint& point = each.points[v];
            const Combination one = evaluation(trade, k, v, Goal::value);
            parameter["values"].push_back(
                {{"name", point.name},
                 {"is_own", v == each.parameter.own},
                 {"is_reference", v == each.parameter.reference},
                 {"draws", point.draws},
                 {"value", to_json(point.of(Goal::value))},
                 {"difference", to_json(point.of(Goal::difference))},
                 {"milliseconds_geometry", milliseconds(one.cost.geometry)},
                 {"milliseconds_scene", milliseconds(one.cost.scene)},
                 {"milliseconds_light", milliseconds(one.cost.path)}});
        }
        json["parameters"].push_back(std::move(parameter));
    }
    for (const Goal goal : {Goal::value, Goal::difference})
        for (const auto fields :
             {Randomness::Fields::one, Randomness::Fields::each}) {
            Json front{{"goal", name_of(goal)}, {"fields", name_of(fields)}};
            for (const Combination& each : pareto_front(trade, goal, fields))
                front["combinations"].push_back(to_json(each, trade));
            json["fronts"].push_back(std::move(front));
        }
    for (const Choice& choice : choices) {
        Json one{{"goal", name_of(choice.goal)},
                 {"fields", name_of(choice.fields)},
                 {"tolerance", choice.tolerance},
                 {"is_met", choice.is_met()},
                 {"combination", to_json(choice.combination, trade)}};
        if (choice.check)
            one["check"] = {
                {"bias", to_json(choice.check->bias)},
                {"standard_error", to_json(choice.check->standard_error)},
                {"milliseconds", milliseconds(choice.check->seconds)}};
        json["choices"].push_back(std::move(one));
    }
    return json;
}

}  // namespace ideotype
