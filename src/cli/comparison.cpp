// SPDX-License-Identifier: Apache-2.0
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "choose_row.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"
#include "output_file.hpp"

namespace ideotype {

namespace {

using Names = std::vector<std::string>;

Sampling sampling_in(const Campaign& under, const Case& chosen,
                     const std::optional<double>& tolerance) {
    SamplingRequest request;
    request.is_final = true;
    request.tolerance = tolerance;
    return sampling_of(request, under, chosen);
}

ComparedPlant read_compared(const std::string& path, const Campaign& under) {
    if (!is_history(path)) {
        const Plant plant = read_crop(path, &under.crop.baseline).baseline;
        return {plant.name, {plant}, {}};
    }
    RowChoice best;
    best.is_best = true;
    const ChosenRow found = choose_row(path, best);
    return {found.campaign.name + "/" + found.chosen.name,
            grow(found.campaign, found.row.candidate.genome),
            {}};
}

//! Names that are there already get a number.
void tell_apart(std::vector<ComparedPlant>& plants) {
    std::map<std::string, int> times;
    for (ComparedPlant& each : plants)
        if (const int n = ++times[each.name]; n > 1)
            each.name += fmt::format(" ({})", n);
}

std::vector<ComparedCase> cases_of(const Campaign& campaign) {
    std::vector<ComparedCase> first;
    for (const Case& each : cases(campaign))
        if (each.replicate == 1)
            for (const Case& scenario : scenarios(each))
                first.push_back(
                    {scenario,
                     scenario.name.substr(0, scenario.name.rfind("_r")),
                     scene_of(campaign, scenario)});
    return first;
}

Layers layers_of(const Campaign& under,
                 const std::vector<ComparedPlant>& plants) {
    Layers layers = canopy_layers(under);
    for (const ComparedPlant& each : plants)
        for (const Plant& plant : each.plants)
            for (const Leaf& leaf : plant.leaves)
                layers.count = std::max(
                    layers.count,
                    static_cast<std::size_t>(
                        std::ceil(furthest(plant, leaf) / layers.thickness)));
    return layers;
}

//! Single numbers, the objectives first, then profiles: layer by layer and leaf
//! by leaf, so that only the end differs between plants.
std::vector<Figure> figures_of(const QuantitySet& measured,
                               const Campaign& campaign) {
    const std::vector<ObjectiveEntry> all = objectives_of(campaign);
    std::vector<Figure> figures;
    const auto add = [&](const Quantity& each) { figures.push_back({each}); };
    const auto is_objective = [&](const Quantity& each) {
        return std::any_of(all.begin(), all.end(),
                           [&](const ObjectiveEntry& objective) {
                               return objective.name == each.name;
                           });
    };
    for (const ObjectiveEntry& objective : all) {
        const std::string unit = unit_of(campaign, objective.quantity);
        if (objective.component) add({objective.name, unit, objective.name});
        for (Quantity each : measured.quantities)
            if (each.name == objective.name) {
                each.unit = unit;
                add(each);
            }
    }
    for (const Quantity& each : measured.quantities)
        if (each.axes.empty() && !is_objective(each)) add(each);
    for (const std::string axis : {"layer", "leaf"})
        for (std::size_t i = 0; i < measured.axis(axis).size(); ++i)
            for (const Quantity& each : measured.quantities)
                if (each.axes == Names{axis}) figures.push_back({each, i});
    return figures;
}

void choose_figures(Comparison& all) {
    for (ComparedPlant& each : all.plants) {
        Scene scene = all.cases.front().scene;
        set_plant(scene.components.front(), each.plants.front());
        each.figures = figures_of(
            canopy_quantities(scene, all.layers, details_of(all.under)),
            all.under);
    }
}

}  // namespace

const std::vector<Figure>& Comparison::figures() const {
    return std::max_element(plants.begin(), plants.end(),
                            [](const auto& a, const auto& b) {
                                return a.figures.size() < b.figures.size();
                            })
        ->figures;
}

std::optional<Estimate> Comparison::value(std::size_t plant, std::size_t chosen,
                                          std::size_t figure) const {
    if (figure >= plants[plant].figures.size()) return std::nullopt;
    return outcomes[plant][chosen].objectives[figure];
}

std::optional<Estimate> Comparison::difference(std::size_t plant,
                                               std::size_t chosen,
                                               std::size_t figure) const {
    if (!value(plant, chosen, figure) || !value(0, chosen, figure))
        return std::nullopt;
    return ideotype::difference(outcomes[0][chosen], outcomes[plant][chosen],
                                figure);
}

std::optional<Estimate> Comparison::relative_gain(std::size_t plant,
                                                  std::size_t chosen,
                                                  std::size_t figure) const {
    if (!difference(plant, chosen, figure) ||
        value(0, chosen, figure)->mean == 0)
        return std::nullopt;
    return ideotype::relative_gain(
        randomisations_of(outcomes[0][chosen], figure),
        randomisations_of(outcomes[plant][chosen], figure));
}

namespace {

Comparison read_comparison(const CompareOptions& options) {
    std::vector<std::string> settings = options.settings;
    if (options.seed) settings.push_back(fmt::format("seed={}", *options.seed));
    Comparison all;
    all.under = read_campaign(options.under, settings);
    all.tolerance = options.tolerance;
    for (const std::string& path : options.plants)
        all.plants.push_back(read_compared(path, all.under));
    tell_apart(all.plants);
    all.cases = cases_of(all.under);
    for (const ComparedCase& each : all.cases)
        if (!each.chosen.stages.empty())
            throw Error(options.under +
                        ": plants grow in it, and compare has them "
                        "full-grown; leave out climate.emergence, or "
                        "evaluate them with ideotype evaluate or Python's "
                        "Stand");
    all.layers = layers_of(all.under, all.plants);
    choose_figures(all);
    all.outcomes.assign(all.plants.size(),
                        std::vector<Outcome>(all.cases.size()));
    return all;
}

//! Evaluates a plant in a case; all plants of a case share their random
//! numbers.
Outcome evaluate(const Comparison& comparison, std::size_t plant,
                 std::size_t chosen, const Device& device) {
    const ComparedPlant& compared = comparison.plants.at(plant);
    const ComparedCase& in = comparison.cases.at(chosen);
    const Sampling sampling =
        sampling_in(comparison.under, in.chosen, comparison.tolerance);
    CanopyRequest request = request_of(sampling, comparison.under, in.chosen,
                                       in.scene, compared.plants);
    request.layers = comparison.layers;
    const CanopyReport report = evaluate(request, device);
    std::map<std::string, std::vector<Randomised>> profiles;
    Outcome outcome;
    outcome.status = Status::done;
    for (const Figure& figure : compared.figures) {
        const std::string& name = figure.quantity.name;
        if (figure.is_of_profile() && !profiles.contains(name))
            profiles[name] = measure_profile(name, report);
        const auto [estimate, values] =
            figure.is_of_profile()
                ? profiles[name].at(figure.place)
                : measure_number(comparison.under, name, report);
        outcome.objectives.push_back(estimate);
        outcome.randomisations.insert(outcome.randomisations.end(),
                                      values.begin(), values.end());
    }
    return outcome;
}

//! Evaluates all plants in all cases.
//! @throws Error that names the first that cannot be evaluated.
void fill(Comparison& all, int threads) {
    const bool is_watched = columns_of(STDERR_FILENO) > 0;
    std::size_t next = 0, done = 0;
    std::exception_ptr failure;
    std::mutex mutex;  // of all three
    const auto take = [&]() -> std::optional<std::size_t> {
        const std::lock_guard lock(mutex);
        return failure || next == all.size() ? std::nullopt
                                             : std::optional(next++);
    };
    const auto work = [&] {
        try {
            const Device device(Device::supported_isas().back());
            while (const auto item = take()) {
                const std::size_t plant = *item % all.plants.size();
                const std::size_t chosen = *item / all.plants.size();
                try {
                    all.outcomes[plant][chosen] =
                        evaluate(all, plant, chosen, device);
                } catch (const Error& error) {
                    throw Error(
                        fmt::format("{} in {}: {}", all.plants[plant].name,
                                    all.cases[chosen].name, error.what()));
                }
                const std::lock_guard lock(mutex);
                ++done;
                if (is_watched)
                    fmt::print(stderr, "\r\x1b[K{} of {} evaluated", done,
                               all.size());
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> workers;
        for (int i = 0; i < threads; ++i) workers.emplace_back(work);
    }
    if (is_watched) fmt::print(stderr, "\r\x1b[K");
    if (failure) std::rethrow_exception(failure);
}

}  // namespace

ExitCode compare(const CompareOptions& options) {
    if (!options.csv_path.empty()) require_new(options.csv_path);
    Comparison comparison = read_comparison(options);
    fill(comparison, options.threads.value_or(available_cores()));
    if (!options.csv_path.empty()) write_csv(options.csv_path, comparison);
    if (options.is_json)
        fmt::print("{}\n", to_text(to_json(comparison)));
    else
        print(comparison);
    return ExitCode::ok;
}

}  // namespace ideotype
