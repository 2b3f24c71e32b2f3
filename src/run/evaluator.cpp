#include "ideotype/run/evaluator.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/hash.hpp"
#include "ideotype/light/tolerance.hpp"
#include "ideotype/run/across_scenarios.hpp"

namespace ideotype {

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

Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen) {
    if (task.is_final)
        return {derive_seed(chosen.seed, "final"), 0, 0,
                Randomness::Fields::each};
    if (is_sensitivity(campaign))
        return {chosen.seed, task.generation,
                task.slot * static_cast<std::uint32_t>(
                                campaign.sampling.randomisations),
                Randomness::Fields::common};
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
    constexpr double thickness = 0.25;
    return {thickness,
            static_cast<std::size_t>(std::ceil(campaign.reach / thickness))};
}

Scenario scenario_of(const Campaign& campaign, const Case& chosen) {
    FieldForm field = campaign.field;
    field.spacing = chosen.spacing;
    return {field,
            illuminate(light_of(campaign, chosen), campaign.sky_model,
                       chosen.spacing.row_direction, Skies::shared,
                       campaign.sun_dates),
            campaign.optics};
}

CanopyRequest request_of(const Task& task, const Campaign& campaign,
                         const Case& chosen, const Scenario& scenario,
                         Plant plant) {
    return {std::move(plant),
            scenario,
            canopy_layers(campaign),
            accuracy_of(task, campaign),
            randomness_of(task, campaign, chosen),
            {.photosynthesis = campaign.photosynthesis},
            campaign.tessellation};
}

OutcomeSchema outcome_schema(const Campaign& campaign, const Case& chosen,
                             const Accuracy& accuracy) {
    OutcomeSchema schema;
    schema.measured = chosen.scenarios.empty()
                          ? measured_in(campaign, chosen)
                          : AcrossScenarios(campaign, chosen).measured();
    schema.randomisations = static_cast<std::size_t>(accuracy.randomisations);
    for (const Aim& aim : aims(campaign))
        schema.objectives.push_back(
            {aim.quantity, unit_of(aim.quantity), aim.sense});
    return schema;
}

Outcome to_outcome(const Campaign& campaign, const Plant& plant,
                   const CanopyReport& report) {
    Outcome outcome;
    outcome.status = Status::done;
    for (const Aim& aim : aims(campaign)) {
        const auto [mean, values] = measure_objective(aim.quantity, report);
        outcome.objectives.push_back(mean);
        outcome.randomisations.insert(outcome.randomisations.end(),
                                      values.begin(), values.end());
    }
    outcome.violation = violation(campaign.constraints, campaign.crop.traits,
                                  plant, report.lai);
    outcome.quantities = measure(report);
    return outcome;
}

CanopyEvaluator::CanopyEvaluator(const Campaign& campaign,
                                 const std::string& isa)
    : campaign_(campaign), device_(isa) {
    for (const Case& each : cases(campaign))
        cases_.emplace_back(campaign, each);
}

CanopyEvaluator::Prepared::Prepared(const Campaign& campaign,
                                    const Case& chosen)
    : schema(outcome_schema(campaign, chosen, campaign.sampling)),
      final_schema(
          outcome_schema(campaign, chosen, campaign.final_rule.sampling)) {
    for (const Case& scenario : ideotype::scenarios(chosen))
        scenarios.push_back({scenario, std::nullopt});
    if (!chosen.scenarios.empty()) across.emplace(campaign, chosen);
}

const OutcomeSchema& CanopyEvaluator::schema(const Task& task) const {
    const Prepared& prepared = cases_.at(task.case_index);
    return task.is_final ? prepared.final_schema : prepared.schema;
}

Outcome CanopyEvaluator::evaluate(const Task& task, const Genome& genome) {
    if (!is_sensitivity(campaign_) || campaign_.sensitivity.keys.empty())
        return evaluate(task, campaign_, cases_.at(task.case_index), genome);
    Genome plain = genome;
    const Campaign varied = at_keys(campaign_, plain);
    Prepared prepared(varied, cases(varied).at(task.case_index));
    return evaluate(task, varied, prepared, plain);
}

Outcome CanopyEvaluator::evaluate(const Task& task, const Campaign& campaign,
                                  Prepared& prepared,
                                  const Genome& genome) const {
    const Plant plant = grow(campaign.crop, genome);
    std::vector<Outcome> outcomes;
    for (auto& [chosen, scenario] : prepared.scenarios) {
        if (!scenario) scenario = scenario_of(campaign, chosen);
        outcomes.push_back(
            to_outcome(campaign, plant,
                       ideotype::evaluate(
                           request_of(task, campaign, chosen, *scenario, plant),
                           device_)));
    }
    return prepared.across ? prepared.across->combine(outcomes)
                           : std::move(outcomes.front());
}

}  // namespace ideotype
