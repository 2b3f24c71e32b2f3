#include "ideotype/run/evaluator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/hash.hpp"
#include "ideotype/light/tolerance.hpp"

namespace ideotype {

namespace {

constexpr double joule_per_megajoule = 1e6;
constexpr auto violation_column = "violation";

std::string clock_name(double hour) {
    const int minutes = static_cast<int>(std::lround(hour * 60));
    return fmt::format("{:02}_{:02}", minutes / 60, minutes % 60);
}

}  // namespace

Accuracy accuracy_of(const Task& task, const Campaign& campaign) {
    if (task.is_final) return campaign.final_rule.sampling;
    Accuracy accuracy = campaign.sampling;
    if (campaign.first_tolerance > 0 && campaign.stop.generations > 1) {
        const double left = 1 - static_cast<double>(task.generation) /
                                    (campaign.stop.generations - 1);
        accuracy.tolerance *=
            std::pow(campaign.first_tolerance / accuracy.tolerance, left);
    }
    return accuracy;
}

Randomness randomness_of(const Task& task, const Case& chosen) {
    if (task.is_final)
        return {derive_seed(chosen.seed, "final"), 0, 0,
                Randomness::Fields::each};
    return {chosen.seed, task.generation};
}

double final_effort(const Campaign& campaign) {
    const auto paths = [](const Accuracy& accuracy) {
        return static_cast<double>(accuracy.all_paths());
    };
    const Accuracy& final = campaign.final_rule.sampling;
    // With a tolerance an evaluation may need the least that there is.
    Accuracy usual = campaign.sampling;
    if (usual.tolerance > 0) usual.paths = std::min(usual.paths, fewest_paths);
    return std::max<double>(paths(final) / paths(usual), final.randomisations);
}

Layers canopy_layers(const Campaign& campaign) {
    double top = 0;
    for (std::size_t i = 0; i < campaign.baseline.size(); ++i)
        top = std::max(top, campaign.plant.leaves[i].insertion_height +
                                std::max(campaign.baseline[i].length,
                                         campaign.bounds[i].length.upper));
    constexpr double thickness = 0.25;
    return {thickness, static_cast<std::size_t>(std::ceil(top / thickness))};
}

Scenario scenario_of(const Campaign& campaign, const Case& chosen) {
    FieldForm field = campaign.field;
    field.spacing = chosen.spacing;
    const Day day = clear_day(chosen.site, chosen.day, campaign.par_fraction);
    return {field,
            illuminate(day, campaign.sky_model, chosen.spacing.row_direction),
            campaign.optics};
}

CanopyRequest request_of(const Task& task, const Campaign& campaign,
                         const Case& chosen, const Scenario& scenario,
                         const Genome& genome) {
    return {Plant{campaign.plant, to_traits(genome), campaign.tessellation},
            scenario,
            canopy_layers(campaign),
            accuracy_of(task, campaign),
            randomness_of(task, chosen),
            {}};
}

OutcomeSchema outcome_schema(const Campaign& campaign, const Day& day) {
    OutcomeSchema schema;
    schema.objectives = {
        campaign.objective == Objective::absorbed_par
            ? Quantity{"absorbed_par", "MJ m-2 day-1"}
            : Quantity{"absorbed_par_per_leaf_area", "MJ m-2 day-1"}};
    schema.diagnostics = {{"incident", "MJ m-2 day-1"},
                          {"absorbed_fraction", "1"},
                          {"stalk_fraction", "1"},
                          {"soil_fraction", "1"},
                          {"reflected_fraction", "1"},
                          {"balance_error", "1"},
                          {"paths", "1"},
                          {"capped", "1"},
                          {"lai", "m2 m-2"},
                          {violation_column, "1"}};
    for (std::size_t leaf = 1; leaf <= campaign.baseline.size(); ++leaf)
        schema.diagnostics.push_back(
            {fmt::format("absorbed_leaf{:02}", leaf), "MJ m-2 day-1"});
    const Layers layers = canopy_layers(campaign);
    for (std::size_t l = 0; l < layers.count; ++l)
        schema.diagnostics.push_back(
            {fmt::format("absorbed_layer_{:03.0f}_{:03.0f}cm",
                         100 * layers.thickness * static_cast<double>(l),
                         100 * layers.thickness * static_cast<double>(l + 1)),
             "MJ m-2 day-1"});
    for (const char* part : {"beam", "sky", "scattered", "adaxial", "abaxial"})
        schema.diagnostics.push_back(
            {fmt::format("absorbed_{}", part), "MJ m-2 day-1"});
    for (const TimeStep& step : day.steps)
        schema.diagnostics.push_back(
            {"absorbed_hour_" + clock_name(step.hour), "W m-2"});
    return schema;
}

Outcome to_outcome(const Campaign& campaign, const Genome& genome,
                   const CanopyReport& report) {
    const BudgetEstimate& day = report.light.day;
    const double to_mj = 1 / joule_per_megajoule;
    // On a day without light nothing is absorbed, of nothing.
    const double to_fraction = day.incident > 0 ? 1 / day.incident : 0;
    Outcome outcome;
    outcome.status = Status::done;
    outcome.objectives = {
        scaled(day.leaves, campaign.objective == Objective::absorbed_par
                               ? to_mj
                               : to_mj / report.lai)};
    outcome.diagnostics = {
        {day.incident * to_mj, 0},
        scaled(day.leaves, to_fraction),
        scaled(day.stalks, to_fraction),
        scaled(day.soil, to_fraction),
        scaled(day.reflected, to_fraction),
        {report.light.balance_error, 0},
        {static_cast<double>(report.paths), 0},
        {report.is_capped ? 1.0 : 0.0, 0},
        {report.lai, 0},
        {violation(campaign.constraints, to_traits(genome), report.lai), 0}};
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (report.groups[g].tissue == Tissue::leaf)
            outcome.diagnostics.push_back(
                scaled(report.light.groups[g], to_mj));
    for (const Estimate& layer : report.light.layers)
        outcome.diagnostics.push_back(scaled(layer, to_mj));
    for (const Estimate& part :
         {day.leaves_beam, day.leaves_sky, day.leaves_scattered,
          report.light.adaxial, report.light.abaxial})
        outcome.diagnostics.push_back(scaled(part, to_mj));
    for (const StepReport& step : report.light.steps)
        outcome.diagnostics.push_back(step.budget.leaves);
    return outcome;
}

double fitness_of(const Outcome& outcome, const OutcomeSchema& schema) {
    if (outcome.status != Status::done)
        return -std::numeric_limits<double>::infinity();
    const auto column = std::find_if(
        schema.diagnostics.begin(), schema.diagnostics.end(),
        [](const Quantity& q) { return q.name == violation_column; });
    if (column != schema.diagnostics.end()) {
        const double violation = outcome
                                     .diagnostics[static_cast<std::size_t>(
                                         column - schema.diagnostics.begin())]
                                     .mean;
        if (violation > 0) return -violation;
    }
    return outcome.objectives.front().mean;
}

CanopyEvaluator::CanopyEvaluator(const Campaign& campaign,
                                 const std::string& isa)
    : campaign_(campaign),
      cases_(cases(campaign)),
      scenarios_(cases_.size()),
      device_(isa) {
    for (const Case& c : cases_)
        schemas_.push_back(outcome_schema(
            campaign, clear_day(c.site, c.day, campaign.par_fraction)));
}

const OutcomeSchema& CanopyEvaluator::schema(const Task& task) const {
    return schemas_.at(task.case_index);
}

Outcome CanopyEvaluator::evaluate(const Task& task, const Genome& genome) {
    const Case& chosen = cases_.at(task.case_index);
    std::optional<Scenario>& scenario = scenarios_[task.case_index];
    if (!scenario) scenario = scenario_of(campaign_, chosen);
    return to_outcome(
        campaign_, genome,
        ideotype::evaluate(
            request_of(task, campaign_, chosen, *scenario, genome), device_));
}

}  // namespace ideotype
