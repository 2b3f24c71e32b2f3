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

//! Returns a text that tells a scenario from others of the same case.
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
    for (const Case& each : scenarios(chosen)) {
        stages_.push_back(std::max<std::size_t>(1, each.stages.size()));
        sets.push_back(
            each.stages.empty()
                ? canopy_quantities(scene_of(campaign, each),
                                    canopy_layers(campaign),
                                    details_of(campaign))
                : over_stages_.emplace_back(campaign, each).measured());
        labels.push_back(label(campaign, each));
    }
    const QuantitySet& first = sets.front();
    if (chosen.scenarios.empty()) {
        measured_ = first;
        return;
    }
    for (const Quantity& each : first.quantities) {
        if (!std::ranges::all_of(sets, [&](const QuantitySet& set) {
                return has_same_axes(each, first, set);
            }))
            continue;
        measured_.quantities.push_back(each);
        shared_.push_back({first.size(each), {}});
        for (const QuantitySet& set : sets)
            shared_.back().begins.push_back(set.offset(each.name));
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

void AcrossScenarios::combine_objective(const std::vector<Outcome>& each,
                                        std::size_t objective,
                                        Outcome& all) const {
    const std::size_t count =
        each.front().randomisations.size() / objectives_.size();
    const std::size_t first = objective * count;
    const auto at = [&](const Outcome& one) {
        return one.objectives[objective];
    };
    if (across_ == Across::worst) {
        const auto worst = std::max_element(
            each.begin(), each.end(), [&](const Outcome& a, const Outcome& b) {
                return is_better(at(a).mean, at(b).mean,
                                 objectives_[objective].sense);
            });
        all.objectives.push_back(at(*worst));
        const auto own = std::span(worst->randomisations).subspan(first, count);
        all.randomisations.insert(all.randomisations.end(), own.begin(),
                                  own.end());
        return;
    }
    std::vector<double> means, values;
    for (const Outcome& one : each) means.push_back(at(one).mean);
    for (std::size_t r = first; r < first + count; ++r) {
        std::vector<double> of_scenarios;
        for (const Outcome& one : each)
            of_scenarios.push_back(one.randomisations[r]);
        values.push_back(mean_of(of_scenarios));
    }
    all.objectives.push_back({mean_of(means), estimate(values).standard_error});
    all.randomisations.insert(all.randomisations.end(), values.begin(),
                              values.end());
}

Outcome AcrossScenarios::combine(const std::vector<Outcome>& each) const {
    IDEOTYPE_EXPECT(each.size() == std::reduce(stages_.begin(), stages_.end()));
    std::vector<Outcome> own;
    std::span<const Outcome> left(each);
    auto over = over_stages_.begin();
    // Either all climates have plants that grow, or none has.
    for (const std::size_t count : stages_) {
        own.push_back(over_stages_.empty()
                          ? left.front()
                          : (over++)->combine(left.first(count)));
        left = left.subspan(count);
    }
    return own.size() == 1 && shared_.empty() ? own.front()
                                              : combine_scenarios(own);
}

Outcome AcrossScenarios::combine_scenarios(
    const std::vector<Outcome>& each) const {
    Outcome all;
    all.status = Status::done;
    for (std::size_t k = 0; k < objectives_.size(); ++k)
        combine_objective(each, k, all);
    for (const Outcome& one : each)
        all.violation = std::max(all.violation, one.violation);
    for (const auto& [size, begins] : shared_)
        for (std::size_t i = 0; i < size; ++i) {
            std::vector<double> means, errors;
            for (std::size_t s = 0; s < each.size(); ++s) {
                const Estimate& x = each[s].quantities[begins[s] + i];
                means.push_back(x.mean);
                errors.push_back(x.standard_error);
            }
            all.quantities.push_back({mean_of(means), mean_of(errors)});
        }
    for (std::size_t k = 0; k < objectives_.size(); ++k)
        for (const Outcome& one : each)
            all.quantities.push_back(one.objectives[k]);
    return all;
}

}  // namespace ideotype
