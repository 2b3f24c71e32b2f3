// SPDX-License-Identifier: Apache-2.0
#include "across_scenarios.hpp"

#include <algorithm>
#include <numeric>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/contract.hpp"
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
    return text;
}

bool has_same_axes(const Quantity& quantity, const QuantitySet& a,
                   const QuantitySet& b) {
    return b.has(quantity.name) &&
           std::ranges::all_of(quantity.axes, [&](const std::string& axis) {
               return a.axis(axis).coordinates == b.axis(axis).coordinates;
           });
}

}  // namespace

AcrossScenarios::AcrossScenarios(const Campaign& campaign, const Case& chosen)
    : across_(campaign.spec.objective.across),
      objectives_(objectives_of(campaign)) {
    std::vector<QuantitySet> sets;
    std::vector<std::string> labels;
    for (const Case& scenario : scenarios(chosen)) {
        stages_.push_back(std::max<std::size_t>(1, scenario.stages.size()));
        sets.push_back(
            scenario.stages.empty()
                ? canopy_quantities(scene_of(campaign, scenario),
                                    canopy_layers(campaign),
                                    details_of(campaign))
                : over_stages_.emplace_back(campaign, scenario).measured());
        labels.push_back(label(campaign, scenario));
    }
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
}

void AcrossScenarios::combine_objective(const std::vector<Outcome>& outcomes,
                                        std::size_t objective,
                                        Outcome& combined) const {
    const std::size_t count =
        outcomes.front().randomisations.size() / objectives_.size();
    const std::size_t first = objective * count;
    const auto at = [&](const Outcome& one) {
        return one.objectives[objective];
    };
    if (across_ == Across::worst) {
        const auto worst =
            std::max_element(outcomes.begin(), outcomes.end(),
                             [&](const Outcome& a, const Outcome& b) {
                                 return is_better(at(a).mean, at(b).mean,
                                                  objectives_[objective].sense);
                             });
        combined.objectives.push_back(at(*worst));
        const auto by_randomisation =
            std::span(worst->randomisations).subspan(first, count);
        combined.randomisations.insert(combined.randomisations.end(),
                                       by_randomisation.begin(),
                                       by_randomisation.end());
        return;
    }
    std::vector<double> means, values;
    for (const Outcome& one : outcomes) means.push_back(at(one).mean);
    for (std::size_t r = first; r < first + count; ++r) {
        std::vector<double> of_scenarios;
        for (const Outcome& one : outcomes)
            of_scenarios.push_back(one.randomisations[r]);
        values.push_back(average(of_scenarios));
    }
    combined.objectives.push_back(
        {average(means), estimate(values).standard_error});
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
            combined.quantities.push_back({average(means), average(errors)});
        }
    for (std::size_t k = 0; k < objectives_.size(); ++k)
        for (const Outcome& one : outcomes)
            combined.quantities.push_back(one.objectives[k]);
    return combined;
}

}  // namespace ideotype
