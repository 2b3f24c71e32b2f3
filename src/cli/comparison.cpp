// SPDX-License-Identifier: Apache-2.0
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "choose_row.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/error.hpp"

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
        return {plant.name, {plant}, {}, {}};
    }
    RowChoice best;
    best.is_best = true;
    const ChosenRow found = choose_row(path, best);
    return {found.campaign.name + "/" + found.chosen.name,
            grow(found.campaign, found.row.candidate.genome),
            {},
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
    const std::vector<Aim> all = aims(campaign);
    std::vector<Figure> figures;
    const auto add = [&](const Quantity& each) { figures.push_back({each}); };
    const auto is_aim = [&](const Quantity& each) {
        return std::any_of(all.begin(), all.end(), [&](const Aim& aim) {
            return aim.name == each.name;
        });
    };
    for (const Aim& aim : all) {
        const std::string unit = unit_of(campaign, aim.quantity);
        if (aim.component) add({aim.name, unit, aim.name});
        for (Quantity each : measured.quantities)
            if (each.name == aim.name) {
                each.unit = unit;
                add(each);
            }
    }
    for (const Quantity& each : measured.quantities)
        if (each.axes.empty() && !is_aim(each)) add(each);
    for (const std::string axis : {"layer", "leaf"})
        for (std::size_t i = 0; i < measured.axis(axis).size(); ++i)
            for (const Quantity& each : measured.quantities)
                if (each.axes == Names{axis}) figures.push_back({each, i});
    return figures;
}

void choose_figures(Comparison& all) {
    const Case& first = all.cases.front().chosen;
    for (ComparedPlant& each : all.plants) {
        Scene scene = all.cases.front().scene;
        set_plant(scene.components.front(), each.plants.front());
        each.figures = figures_of(
            canopy_quantities(scene, all.layers, details_of(all.under)),
            all.under);
        for (const Figure& figure : each.figures)
            each.schema.objectives.push_back(
                {figure.quantity.name, figure.quantity.unit});
        each.schema.randomisations = static_cast<std::size_t>(
            sampling_in(all.under, first, all.tolerance).accuracy.replicates());
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

}  // namespace ideotype
