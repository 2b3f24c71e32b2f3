// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "across_scenarios.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/contract.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

using Names = std::vector<std::string>;

//! Names of quantities that are reported for each stage, by day of the season.
const Names told_by_stage{"lai",          "dead_area_index",  "fapar",
                          "absorbed_par", "net_assimilation", "carbon_balance"};

//! Returns whether entries of an axis are matched by name because they differ
//! between stages: a stage does not cover all days, and young plants lack
//! organs.
bool is_matched(const std::string& axis) {
    return axis == "day" || axis == "organ";
}

//! Returns an axis with the entries of all stages: days in order, or organs,
//! with those that full-grown plants lack at the end.
Axis axis_of_all(const std::vector<QuantitySet>& sets,
                 const std::string& name) {
    Axis axis = sets.back().axis(name);
    auto names = std::get<Names>(axis.coordinates);
    for (const QuantitySet& set : sets)
        for (const std::string& each :
             std::get<Names>(set.axis(name).coordinates))
            if (std::ranges::count(names, each) == 0) names.push_back(each);
    if (name == "day") std::ranges::sort(names);
    axis.coordinates = std::move(names);
    return axis;
}

}  // namespace

void OverStages::add(const Quantity& quantity,
                     const std::vector<QuantitySet>& sets) {
    const bool is_by_name =
        quantity.axes.size() == 1 && is_matched(quantity.axes.front());
    if (std::ranges::count(quantity.axes, "hour") > 0) return;
    Summed summed{mean_over(quantity.name), 0, {}, {}};
    std::map<std::string, std::size_t> place_of;
    if (is_by_name)
        for (const std::string& name :
             std::get<Names>(measured_.axis(quantity.axes.front()).coordinates))
            place_of.emplace(name, place_of.size());
    for (const QuantitySet& set : sets) {
        if (!set.has(quantity.name)) return;
        for (const std::string& axis : quantity.axes)
            if (!is_by_name &&
                set.axis(axis).coordinates != sets[0].axis(axis).coordinates)
                return;
        summed.begins.push_back(set.offset(quantity.name));
        std::vector<std::size_t>& places = summed.places.emplace_back();
        if (is_by_name)
            for (const std::string& name :
                 std::get<Names>(set.axis(quantity.axes.front()).coordinates))
                places.push_back(place_of.at(name));
        else
            for (std::size_t i = 0; i < sets[0].size(quantity); ++i)
                places.push_back(i);
    }
    summed.size = is_by_name ? place_of.size() : sets[0].size(quantity);
    measured_.quantities.push_back(quantity);
    summed_.push_back(std::move(summed));
}

OverStages::OverStages(const Campaign& campaign, const Case& chosen)
    : objectives_(objectives_of(campaign)) {
    // Quantities of each stage, and the weights of stages.
    std::vector<QuantitySet> sets;
    std::vector<double> at;
    for (const Case& stage_case : chosen.stages) {
        const Scene scene = scene_of(campaign, stage_case);
        sets.push_back(canopy_quantities(scene, canopy_layers(campaign),
                                         details_of(campaign)));
        const LightSeries& series = scene.light().series;
        double time = 0;
        for (const TimeStep& step : series.steps) time += step.seconds;
        times_.push_back(time / (series.days * 86400.));
        days_.push_back(stage_case.stage->day);
        at.push_back(stage_case.stage->at);
        incident_.push_back(sets.back().offset("incident"));
        absorbed_.push_back(sets.back().offset("absorbed_par"));
        lai_.push_back(sets.back().offset("lai"));
        if (scene.water)
            transpired_.push_back(sets.back().offset("transpiration"));
    }
    // Quantities of the season, with the axes that they use.
    measured_.axes = sets.front().axes;
    for (Axis& axis : measured_.axes)
        if (is_matched(axis.name)) axis = axis_of_all(sets, axis.name);
    for (const Quantity& each : sets.front().quantities) add(each, sets);
    std::erase_if(measured_.axes, [&](const Axis& axis) {
        return std::ranges::none_of(
            measured_.quantities, [&](const Quantity& each) {
                return std::ranges::count(each.axes, axis.name) > 0;
            });
    });
    // Quantities by stage.
    measured_.axes.push_back(
        {"stage", "deg C d", "thermal time since emergence", std::move(at)});
    for (const std::string& name : told_by_stage) {
        const auto quantity = std::ranges::find_if(
            sets[0].quantities,
            [&](const Quantity& each) { return each.name == name; });
        if (quantity == sets[0].quantities.end()) continue;
        ByStage by{{}, mean_over(name) == MeanOver::nothing};
        for (const QuantitySet& set : sets)
            by.begins.push_back(set.offset(name));
        by_stage_.push_back(std::move(by));
        measured_.quantities.push_back(
            {name + "_by_stage",
             quantity->unit,
             quantity->meaning + " on a mean day of the stage",
             {"stage"},
             quantity->certainty});
    }
    measured_.quantities.push_back({"day_of_stage",
                                    "d",
                                    "days since emergence",
                                    {"stage"},
                                    Certainty::exact});
    for (const ObjectiveEntry& objective : objectives_)
        objective_weights_.push_back(mean_over(objective.quantity));
}

std::vector<double> OverStages::weights(
    MeanOver kind, std::span<const Outcome> outcomes) const {
    const std::vector<std::size_t>* by = &lai_;
    switch (kind) {
        case MeanOver::nothing:
            return std::vector(outcomes.size(), 1.);
        case MeanOver::time:
            return times_;
        case MeanOver::incident_light:
            by = &incident_;
            break;
        case MeanOver::absorbed_light:
            by = &absorbed_;
            break;
        case MeanOver::transpired_water:
            by = &transpired_;
            break;
        case MeanOver::leaf_area:
        case MeanOver::leaf_area_time:
            break;
    }
    std::vector<double> shares;
    double sum = 0;
    for (std::size_t s = 0; s < outcomes.size(); ++s) {
        shares.push_back(outcomes[s].quantities[(*by)[s]].mean);
        if (kind == MeanOver::leaf_area_time) shares.back() *= times_[s];
        // Amounts per leaf area already include the duration of the stage.
        sum += shares.back() * (kind == MeanOver::leaf_area ? times_[s] : 1);
    }
    for (double& x : shares) x = sum > 0 ? x / sum : 0;
    return shares;
}

Outcome OverStages::combine(std::span<const Outcome> outcomes) const {
    IDEOTYPE_EXPECT(outcomes.size() == times_.size());
    Outcome combined;
    combined.status = Status::done;
    const std::size_t count =
        outcomes.front().randomisations.size() / objectives_.size();
    // Objectives, also by randomisation.
    for (std::size_t k = 0; k < objectives_.size(); ++k) {
        const std::vector<double> by = weights(objective_weights_[k], outcomes);
        std::vector<double> values(count);
        double mean = 0;
        for (std::size_t s = 0; s < outcomes.size(); ++s) {
            mean += by[s] * outcomes[s].objectives[k].mean;
            for (std::size_t r = 0; r < count; ++r)
                values[r] += by[s] * outcomes[s].randomisations[k * count + r];
        }
        // The outcome of a single stage is preserved bit for bit.
        combined.objectives.push_back(
            {mean, outcomes.size() == 1
                       ? outcomes[0].objectives[k].standard_error
                       : estimate(values).standard_error});
        combined.randomisations.insert(combined.randomisations.end(),
                                       values.begin(), values.end());
    }
    for (const Outcome& one : outcomes)
        combined.violation = std::max(combined.violation, one.violation);
    // Weighted sums of quantities; errors of stages are independent.
    for (const auto& [kind, size, begins, places] : summed_) {
        const std::vector<double> by = weights(kind, outcomes);
        std::vector<Estimate> sum(size);
        for (std::size_t s = 0; s < outcomes.size(); ++s)
            for (std::size_t i = 0; i < places[s].size(); ++i) {
                const Estimate x =
                    scaled(outcomes[s].quantities[begins[s] + i], by[s]);
                Estimate& into = sum[places[s][i]];
                into.mean += x.mean;
                into.standard_error =
                    std::hypot(into.standard_error, x.standard_error);
            }
        combined.quantities.insert(combined.quantities.end(), sum.begin(),
                                   sum.end());
    }
    // Quantities by stage; amounts are per day of the stage.
    for (const auto& [begins, is_amount] : by_stage_)
        for (std::size_t s = 0; s < outcomes.size(); ++s)
            combined.quantities.push_back(
                scaled(outcomes[s].quantities[begins[s]],
                       is_amount && times_[s] > 0 ? 1 / times_[s] : 1));
    for (const double day : days_) combined.quantities.push_back({day, 0});
    return combined;
}

}  // namespace ideotype
