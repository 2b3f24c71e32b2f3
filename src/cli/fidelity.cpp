// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fidelity_output.hpp"
#include "ideotype/cli/verbs.hpp"
#include "ideotype/run/progress.hpp"
#include "output_file.hpp"

namespace ideotype {

namespace {

//! Part of the time for evaluating choices again.
constexpr double for_checks = 0.25;

std::vector<double> tolerances(double asked) {
    std::vector<double> all{1e-2, 3e-3, 1e-3};
    if (std::find(all.begin(), all.end(), asked) == all.end())
        all.push_back(asked);
    std::sort(all.rbegin(), all.rend());
    return all;
}

std::vector<Choice> choose(const Trade& trade, const FidelityOptions& options,
                           const Device& device, LiveLine& live) {
    const std::vector<double> all = tolerances(options.tolerance);
    const double each =
        for_checks * options.seconds / (4 * static_cast<double>(all.size()));
    std::vector<Choice> choices;
    for (const Goal goal : {Goal::value, Goal::difference})
        for (const auto fields :
             {Randomness::Fields::one, Randomness::Fields::each}) {
            const std::vector<Combination> front =
                pareto_front(trade, goal, fields);
            for (const double tolerance : all) {
                Choice choice{goal, fields, tolerance,
                              cheapest(front, tolerance), std::nullopt};
                live.show(fmt::format("evaluating again at {}", tolerance));
                if (choice.is_met())
                    choice.check = check_combination(trade, choice.combination,
                                                     goal, device, each);
                choices.push_back(std::move(choice));
            }
        }
    return choices;
}

void write(const Json& json, const std::string& path) {
    OutputFile file(path);
    file.print("{}\n", to_text(json));
    file.finish();
}

}  // namespace

ExitCode fidelity(const FidelityOptions& options) {
    const double began = now();
    const Campaign campaign =
        read_campaign(options.campaign_path, options.settings);
    const Case chosen =
        case_at(campaign, options.case_index, options.campaign_path);
    const Device device(Device::supported_isas().back());
    LiveLine live(options.level);
    const Trade trade = measure_trade(
        campaign, static_cast<std::size_t>(chosen.index), device,
        {.seconds = (1 - for_checks) * options.seconds},
        [&](const std::string& what, double part) {
            live.show(fmt::format("{:3.0f} %  {} left  {}", 100 * part,
                                  format_duration((1 - part) * options.seconds),
                                  what));
        });
    const std::vector<Choice> choices = choose(trade, options, device, live);
    fmt::print("case {}, measured in {:.0f} s\n", chosen.name, now() - began);
    print_trade(trade);
    print_choices(trade, choices, options.tolerance);
    if (!options.json_path.empty())
        write(to_json(trade, choices), options.json_path);
    return ExitCode::ok;
}

}  // namespace ideotype
