// SPDX-License-Identifier: Apache-2.0
#include "sensitivity_command.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/text.hpp"
#include "ideotype/run/sensitivity.hpp"
#include "json.hpp"
#include "output_file.hpp"

namespace ideotype {

namespace {

std::size_t find(const SensitivityForm& form, const std::string& quantity) {
    const auto found = std::ranges::find(form.quantities, quantity);
    if (found != form.quantities.end())
        return static_cast<std::size_t>(found - form.quantities.begin());
    throw Error(
        fmt::format("--quantity: there is no '{}'; {}; the study is finished, "
                    "so add --resume",
                    quantity, did_you_mean(quantity, form.quantities)),
        ExitCode::usage);
}

void print(const SensitivityCommand& command, const History& history,
           std::size_t samples) {
    const HistoryHeader& header = history.header();
    const SensitivityForm& form = *header.sensitivity;
    const auto found = history.sensitivity();
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < header.schema.objectives.size(); ++i)
        chosen.push_back(i);
    for (const std::string& each : command.quantities)
        chosen.push_back(find(form, each));
    for (const std::size_t i : chosen)
        fmt::print("\n{}", printable_lines(header.text.at("case") + "  " +
                                           sensitivity_text(form, found, i)));
    const std::string lacking = lacking_samples(found, samples);
    if (!lacking.empty()) fmt::print("{}\n", lacking);
}

Json to_json(const History& history) {
    const SensitivityForm& form = *history.header().sensitivity;
    const auto found = history.sensitivity();
    const auto indices = sensitivity_indices(form.method);
    Json quantities;
    for (std::size_t i = 0; i < found.size(); ++i) {
        Json factors;
        for (std::size_t k = 0; k < form.factors.size(); ++k)
            for (std::size_t j = 0; j < indices.size(); ++j)
                factors[form.factors[k]][indices[j].name] =
                    to_json(found[i].indices[j][k]);
        quantities[form.quantities[i]] = {
            {"unit", form.units[i]},
            {"mean", found[i].mean},
            {"standard_deviation", found[i].standard_deviation},
            {"noise_standard_deviation", found[i].noise},
            {"samples", found[i].samples},
            {"factors", factors}};
    }
    return {{"case", history.header().text.at("case")},
            {"quantities", quantities}};
}

void tell(const SensitivityCommand& command, const RunOptions& options) {
    const Campaign campaign =
        read_campaign(options.campaign_path, options.settings);
    Json json = Json::array();
    for (const Case& each : cases(campaign)) {
        if (options.case_index.value_or(each.index) != each.index) continue;
        const History history =
            History::read(path_of(options.out, campaign, each));
        // Another job may work on it.
        if (!history.finished()) continue;
        print(command, history,
              static_cast<std::size_t>(campaign.search.sensitivity.samples));
        json.push_back(to_json(history));
    }
    if (command.json_path.empty()) return;
    OutputFile file(command.json_path);
    file.print("{}\n", to_text(json));
    file.finish();
}

}  // namespace

void declare_sensitivity(CLI::App& verb, SensitivityCommand& command) {
    command.run.options.out = "results/sensitivity";
    declare_run(verb, command.run);
    verb.add_option("--quantity", command.quantities,
                    "print the indices of this quantity too, such as lai; all "
                    "stand in the history");
    verb.add_option("--json", command.json_path,
                    "also write the indices of all quantities to this file");
}

ExitCode start_sensitivity(const SensitivityCommand& command) {
    RunCommand run = command.run;
    // Replicates would be the same study with other random numbers.
    run.options.settings.insert(
        run.options.settings.begin(),
        {"search.optimizer=sensitivity", "replicates=1"});
    return start_run(
        run, [&](const RunOptions& options) { tell(command, options); });
}

}  // namespace ideotype
