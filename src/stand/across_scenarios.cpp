// SPDX-License-Identifier: Apache-2.0
#include "across_scenarios.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "search/order.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! Returns a label that distinguishes a scenario from others of the same case.
std::string label(const Campaign& campaign, const Case& scenario) {
    std::string text;
    const auto add = [&](bool is_named, const std::string& name) {
        if (is_named) text += (text.empty() ? "" : "_") + name;
    };
    add(is_over(campaign.spec, "site"), scenario.site_name);
    add(is_over(campaign.spec, "day") || is_over(campaign.spec, "climate"),
        scenario.day_name);
    add(is_over(campaign.spec, "spacing"), scenario.spacing_name);
    add(is_over(campaign.spec, "draw"), scenario.draw_name);
    return text;
}

//! @param weights with a sum of 1; empty: all are equal
double weighted_average(const std::vector<double>& values,
                        const std::vector<double>& weights) {
    if (weights.empty()) return average(values);
    double sum = 0;
    // Scenarios without weight do not count, whatever their value.
    for (std::size_t i = 0; i < values.size(); ++i)
        if (weights[i] > 0) sum += weights[i] * values[i];
    return sum;
}

}  // namespace

AcrossScenarios::AcrossScenarios(const Campaign& campaign, const Case& chosen)
    : rule_(campaign.spec.objective), objectives_(objectives_of(campaign)) {
    std::vector<QuantitySet> sets;
    std::vector<std::string> labels;
    for (const Case& scenario : scenarios(chosen)) {
        const Campaign& here = campaign_in(campaign, scenario);
        stages_.push_back(std::max<std::size_t>(1, scenario.stages.size()));
        sets.push_back(
            scenario.stages.empty()
                ? canopy_quantities(scene_of(here, scenario),
                                    canopy_layers(here), details_of(here))
                : over_stages_.emplace_back(here, scenario).measured());
        labels.push_back(label(campaign, scenario));
        weights_.push_back(scenario.weight);
    }
    if (std::ranges::all_of(weights_,
                            [&](double x) { return x == weights_.front(); }))
        weights_.clear();
    const double sum = std::reduce(weights_.begin(), weights_.end());
    for (double& x : weights_) x /= sum;
    const QuantitySet& first = sets.front();
    if (chosen.scenarios.empty()) {
        measured_ = first;
        return;
    }
    for (const Quantity& quantity : first.quantities) {
        if (!std::ranges::all_of(sets, [&](const QuantitySet& set) {
                return has_same_axes(quantity, first, set);
            }))
            continue;
        measured_.quantities.push_back(quantity);
        shared_.push_back({first.size(quantity), {}});
        for (const QuantitySet& set : sets)
            shared_.back().begins.push_back(set.offset(quantity.name));
    }
    for (const Axis& axis : first.axes)
        if (std::ranges::any_of(
                measured_.quantities, [&](const Quantity& each) {
                    return std::ranges::count(each.axes, axis.name) > 0;
                }))
            measured_.axes.push_back(axis);
    measured_.axes.push_back(
        {"scenario", "", "what plants are evaluated under", labels});
    for (const ObjectiveEntry& objective : objectives_)
        measured_.quantities.push_back({objective.name + "_by_scenario",
                                        unit_of(campaign, objective.quantity),
                                        objective.name + " in each scenario",
                                        {"scenario"}});
    const auto is_objective = [&](const std::string& name) {
        return std::ranges::any_of(
            objectives_,
            [&](const ObjectiveEntry& each) { return each.name == name; });
    };
    // Prices may change after the search, and weights are needed for means.
    if (campaign.spec.prices)
        for (const char* const name : priced_quantities) {
            if (!first.has(name) || is_objective(name)) continue;
            by_scenario_.push_back(mapped(sets, [&](const QuantitySet& set) {
                return set.offset(name);
            }));
            measured_.quantities.push_back(
                {std::string(name) + "_by_scenario",
                 unit_of(name),
                 std::string(name) + " in each scenario",
                 {"scenario"}});
        }
    if (!weights_.empty())
        measured_.quantities.push_back({"scenario_weight",
                                        "1",
                                        "weight of each scenario",
                                        {"scenario"},
                                        Certainty::exact});
}

std::vector<double> AcrossScenarios::weights(
    const std::vector<Outcome>& outcomes, std::size_t objective) const {
    if (rule_.across == Across::mean) return weights_;
    const std::size_t count = outcomes.size();
    const Sense sense = objectives_[objective].sense;
    std::vector<std::size_t> order(count);  // the worst scenario first
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return is_better(outcomes[b].objectives[objective].mean,
                         outcomes[a].objectives[objective].mean, sense);
    });
    constexpr double rounding = 1e-9;
    std::vector<double> chosen(count);
    if (rule_.across == Across::worst) {
        chosen[order.front()] = 1;
        return chosen;
    }
    double left = rule_.tail;
    for (const std::size_t s : order) {
        const double weight =
            weights_.empty() ? 1 / static_cast<double>(count) : weights_[s];
        const bool is_last = weight >= left - rounding;
        if (rule_.across == Across::cvar)
            chosen[s] = std::min(weight, left) / rule_.tail;
        else if (is_last)
            chosen[s] = 1;
        left -= weight;
        if (is_last) break;
    }
    return chosen;
}

void AcrossScenarios::combine_objective(const std::vector<Outcome>& outcomes,
                                        std::size_t objective,
                                        Outcome& combined) const {
    const std::size_t count =
        outcomes.front().randomisations.size() / objectives_.size();
    const std::size_t first = objective * count;
    const auto values_of = [&](std::size_t r) {
        return mapped(outcomes, [&](const Outcome& one) {
            return one.randomisations[r];
        });
    };
    std::vector<double> values;
    double mean = 0;
    if (rule_.across == Across::probability) {
        const auto reaches = [&](double x) { return x >= *rule_.threshold; };
        for (std::size_t r = first; r < first + count; ++r)
            values.push_back(weighted_average(
                mapped(values_of(r),
                       [&](double x) { return reaches(x) ? 1. : 0.; }),
                weights_));
        mean = average(values);
    } else {
        const std::vector<double> by = weights(outcomes, objective);
        for (std::size_t r = first; r < first + count; ++r)
            values.push_back(weighted_average(values_of(r), by));
        // The estimate of a single scenario is preserved bit for bit.
        const auto only = std::ranges::find(by, 1.);
        if (only != by.end()) {
            combined.objectives.push_back(
                outcomes[static_cast<std::size_t>(only - by.begin())]
                    .objectives[objective]);
            combined.randomisations.insert(combined.randomisations.end(),
                                           values.begin(), values.end());
            return;
        }
        mean =
            weighted_average(mapped(outcomes,
                                    [&](const Outcome& one) {
                                        return one.objectives[objective].mean;
                                    }),
                             by);
    }
    combined.objectives.push_back({mean, estimate(values).standard_error});
    combined.randomisations.insert(combined.randomisations.end(),
                                   values.begin(), values.end());
}

Outcome AcrossScenarios::combine(const std::vector<Outcome>& outcomes) const {
    IDEOTYPE_EXPECT(outcomes.size() ==
                    std::reduce(stages_.begin(), stages_.end()));
    std::vector<Outcome> by_scenario;
    std::span<const Outcome> left(outcomes);
    auto over = over_stages_.begin();
    // Plants grow in all climates or in none.
    for (const std::size_t count : stages_) {
        by_scenario.push_back(over_stages_.empty()
                                  ? left.front()
                                  : (over++)->combine(left.first(count)));
        left = left.subspan(count);
    }
    return by_scenario.size() == 1 && shared_.empty()
               ? by_scenario.front()
               : combine_scenarios(by_scenario);
}

Outcome AcrossScenarios::combine_scenarios(
    const std::vector<Outcome>& outcomes) const {
    Outcome combined;
    combined.status = Status::done;
    for (std::size_t k = 0; k < objectives_.size(); ++k)
        combine_objective(outcomes, k, combined);
    for (const Outcome& one : outcomes)
        combined.violation = std::max(combined.violation, one.violation);
    for (const auto& [size, begins] : shared_)
        for (std::size_t i = 0; i < size; ++i) {
            std::vector<double> means, errors;
            for (std::size_t s = 0; s < outcomes.size(); ++s) {
                const Estimate& x = outcomes[s].quantities[begins[s] + i];
                means.push_back(x.mean);
                errors.push_back(x.standard_error);
            }
            combined.quantities.push_back({weighted_average(means, weights_),
                                           weighted_average(errors, weights_)});
        }
    for (std::size_t k = 0; k < objectives_.size(); ++k)
        for (const Outcome& one : outcomes)
            combined.quantities.push_back(one.objectives[k]);
    for (const std::vector<std::size_t>& indices : by_scenario_)
        for (std::size_t s = 0; s < outcomes.size(); ++s)
            combined.quantities.push_back(outcomes[s].quantities[indices[s]]);
    for (const double weight : weights_)
        combined.quantities.push_back({weight, 0});
    return combined;
}

}  // namespace ideotype
