// SPDX-License-Identifier: Apache-2.0
#include "stand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/hash.hpp"
#include "ideotype/light/tolerance.hpp"
#include "spec/problems.hpp"
#include "spec/varied_keys.hpp"

namespace ideotype {

Accuracy accuracy_of(const Task& task, const Campaign& campaign) {
    constexpr double largest = 0.05;
    constexpr int most_paths = 1 << 20;
    constexpr int fewest =
        8;  // smallest number with which a tolerance can be tested
    Accuracy accuracy =
        task.is_final ? campaign.final_rule.sampling : campaign.sampling;
    if (task.tolerance) {
        if (!(*task.tolerance > 0 && *task.tolerance <= largest))
            throw wrong_usage(
                "the tolerance is {} (a relative standard error); it must be "
                "above 0 and at most {}",
                *task.tolerance, largest);
        accuracy.randomisations = std::max(accuracy.randomisations, fewest);
        accuracy.paths = std::max(accuracy.paths, most_paths);
        accuracy.tolerance = *task.tolerance;
    }
    if (task.is_final) accuracy.fields = accuracy.randomisations;
    return accuracy;
}

Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen) {
    const std::uint64_t seed =
        task.seed ? derive_seed(*task.seed, chosen.name) : chosen.seed;
    if (task.is_final) return {derive_seed(seed, "final")};
    if (campaign.has_light_by_row) {
        // Each stage of a row has randomisations too.
        const int scenes = campaign.sampling.randomisations *
                           campaign.spec.light.stages.value_or(1);
        return {seed, task.generation,
                task.slot * static_cast<std::uint32_t>(scenes),
                campaign.sampling.fields == 1};
    }
    return {seed, task.generation};
}

Sampling sampling_of(const Task& task, const Campaign& campaign,
                     const Case& chosen) {
    return {accuracy_of(task, campaign), randomness_of(task, campaign, chosen)};
}

double final_effort(const Campaign& campaign) {
    const auto paths = [](const Accuracy& accuracy) {
        return static_cast<double>(accuracy.all_paths());
    };
    const Accuracy& final = campaign.final_rule.sampling;
    // With a tolerance, an evaluation may end after the smallest number of
    // paths.
    Accuracy usual = campaign.sampling;
    if (usual.tolerance > 0) usual.paths = std::min(usual.paths, fewest_paths);
    return std::max<double>(paths(final) / paths(usual), final.randomisations);
}

OutcomeSchema outcome_schema(const Campaign& campaign, const Case& chosen,
                             const Accuracy& accuracy) {
    OutcomeSchema schema;
    schema.measured = AcrossScenarios(campaign, chosen).measured();
    schema.randomisations = static_cast<std::size_t>(accuracy.repetitions());
    for (const ObjectiveEntry& objective : objectives_of(campaign))
        schema.objectives.push_back(
            {objective.name, unit_of(campaign, objective), objective.sense});
    return schema;
}

OutcomeSchema search_schema(const Campaign& campaign, const Case& chosen,
                            const Accuracy& accuracy) {
    OutcomeSchema schema = outcome_schema(campaign, chosen, accuracy);
    const std::vector<KeyFactor>& keys = campaign.varied.keys;
    for (std::size_t i = 0; i < keys.size(); ++i)
        for (const double number : tried_numbers(keys[i])) {
            Genome genome = baseline_genome(campaign);
            for (std::size_t k = 0; k < keys.size(); ++k)
                genome.push_back(k == i ? number : keys[k].number);
            const Campaign varied = at_keys(campaign, genome);
            const QuantitySet measured =
                outcome_schema(varied, cases(varied).at(chosen.index), accuracy)
                    .measured;
            QuantitySet& shared = schema.measured;
            std::erase_if(shared.quantities, [&](const Quantity& quantity) {
                return !has_same_axes(quantity, shared, measured);
            });
        }
    std::erase_if(schema.measured.axes, [&](const Axis& axis) {
        return std::ranges::none_of(
            schema.measured.quantities, [&](const Quantity& quantity) {
                return std::ranges::count(quantity.axes, axis.name) > 0;
            });
    });
    return schema;
}

namespace {

double constrained_lai(const Campaign& campaign, const Case& chosen,
                       const Plant& plant, const CanopyReport& report) {
    const ComponentReport& bred = report.components.front();
    return campaign.spec.field.variation.is_any() || report.grows
               ? lai_of_line(build_plant(at_density(campaign, chosen, 0, plant),
                                         campaign.spec.plant.tessellation),
                             bred.ground_per_plant)
               : bred.lai;
}

}  // namespace

double lai_of_line(const Mesh& plant, double ground_per_plant) {
    IDEOTYPE_EXPECT(ground_per_plant > 0);
    return plant_area(plant).leaves / ground_per_plant;
}

Randomised measure_number(const Campaign& campaign, const std::string& name,
                          const CanopyReport& report) {
    const std::vector<ObjectiveEntry> objectives = objectives_of(campaign);
    const auto objective = std::ranges::find_if(
        objectives, [&](const ObjectiveEntry& x) { return x.name == name; });
    if (objective != objectives.end() && objective->component)
        return measure_parts(objective->quantity, report)
            .at(*objective->component);
    const std::vector<double> weights = component_weights(campaign);
    return objective != objectives.end() && !weights.empty()
               ? weighted_sum(measure_parts(name, report), weights)
               : measure_objective(name, report);
}

Estimate land_equivalent_ratio(const Campaign& campaign,
                               const CanopyReport& report) {
    IDEOTYPE_EXPECT(!campaign.spec.objective.sole.empty());
    const std::string quantity = objectives_of(campaign).front().quantity;
    Estimate ratio = measure_number(campaign, quantity, report).estimate;
    const std::vector<Randomised> parts = measure_parts(quantity, report);
    for (std::size_t c = 0; c < campaign.spec.objective.sole_errors.size(); ++c)
        ratio.standard_error = std::hypot(
            ratio.standard_error, parts[c].estimate.mean /
                                      campaign.spec.objective.sole[c] *
                                      campaign.spec.objective.sole_errors[c] /
                                      campaign.spec.objective.sole[c]);
    return ratio;
}

Outcome to_outcome(const Campaign& campaign, const Case& chosen,
                   const Plant& plant, const CanopyReport& report) {
    Outcome outcome;
    outcome.status = Status::done;
    for (const ObjectiveEntry& objective : objectives_of(campaign)) {
        const auto [mean, values] =
            measure_number(campaign, objective.name, report);
        outcome.objectives.push_back(mean);
        outcome.randomisations.insert(outcome.randomisations.end(),
                                      values.begin(), values.end());
    }
    outcome.violation =
        violation(campaign.spec.constraints, campaign.crop.traits, plant,
                  constrained_lai(campaign, chosen, plant, report));
    if (const double limit = campaign.spec.feasibility.limit;
        report.lines && limit > 0)
        outcome.violation += std::max(0.0, report.lines->from_mean / limit - 1);
    outcome.quantities = measure(report);
    return outcome;
}

namespace {

//! Returns whether two stages have the same plants, light and paths.
bool has_same_light(const std::optional<Stage>& a,
                    const std::optional<Stage>& b) {
    if (!a || !b) return !a && !b;
    return a->number == b->number && a->at == b->at && a->before == b->before &&
           a->after == b->after && a->ages == b->ages &&
           a->ages_before == b->ages_before && a->share == b->share &&
           a->date == b->date;
}

//! Returns whether two scenarios differ by their draws alone, and have the same
//! stages.
bool differ_by_draw(const Case& a, const Case& b) {
    return a.site_name == b.site_name && a.day_name == b.day_name &&
           a.spacing_name == b.spacing_name &&
           std::ranges::equal(a.stages, b.stages, has_same_light, &Case::stage,
                              &Case::stage);
}

}  // namespace

Stand::Stand(const Campaign& campaign, const Case& chosen)
    : campaign_(campaign),
      cases_(evaluated_cases(chosen)),
      cue_(campaign, cases_),
      across_(campaign, chosen),
      schema_(outcome_schema(campaign, chosen, campaign.sampling)),
      final_schema_(schema_) {
    const std::vector<Case> all = scenarios(chosen);
    const bool is_shared =
        !campaign.spec.draws.empty() && !draws_change_light(campaign.spec);
    std::size_t first = 0;
    for (const Case& scenario : all) {
        const auto same = std::ranges::find_if(all, [&](const Case& earlier) {
            return &earlier == &scenario ||
                   (is_shared && differ_by_draw(earlier, scenario));
        });
        scenarios_.push_back({first,
                              std::max<std::size_t>(1, scenario.stages.size()),
                              Season(campaign_in(campaign, scenario), scenario),
                              static_cast<std::size_t>(same - all.begin())});
        first += scenarios_.back().cases;
    }
    final_schema_.randomisations =
        static_cast<std::size_t>(campaign.final_rule.sampling.randomisations);
}

void Stand::prepare(const Device& device) {
    if (!scenes_.empty()) return;
    for (const Case& each : cases_)
        scenes_.push_back(scene_of(campaign_in(campaign_, each), each));
    std::vector<std::size_t> lights;
    for (const Scenario& scenario : scenarios_)
        for (std::size_t s = 0; s < scenario.cases; ++s)
            lights.push_back(scenarios_[scenario.light].first + s);
    cue_.prepare(device, lights);
    works_.resize(cases_.size());
    if (campaign_.sampling.tolerance > 0) find_work(device);
}

//! Finds the work of each case by trials for the baseline, with random numbers
//! that depend on no seed. If the baseline cannot be evaluated, each plant has
//! separate trials.
void Stand::find_work(const Device& device) {
    const Plants baseline{campaign_.crop.baseline};
    const Sampling sampling{campaign_.sampling, Randomness{}};
    LightCue::Response response(cue_);
    try {
        for (const Scenario& scenario : scenarios_) {
            if (scenarios_[scenario.light].first != scenario.first) continue;
            for (std::size_t i = 0; i < scenario.cases; ++i) {
                const std::size_t number = scenario.first + i;
                works_[number] = ideotype::find_work(
                    request(number, baseline, sampling, response), device);
                // The light of a stage decides the plants of the next one.
                if (cue_.is_any() && i + 1 < scenario.cases)
                    light({number}, baseline, sampling, device, response, {});
            }
        }
    } catch (const Error&) {
        works_.assign(cases_.size(), std::nullopt);
    }
}

CanopyRequest Stand::request(std::size_t number, const Plants& plants,
                             const Sampling& sampling,
                             LightCue::Response& response) const {
    const Case& in = cases_[number];
    CanopyRequest request = request_of(sampling, campaign_in(campaign_, in), in,
                                       scenes_[number], plants);
    response.set_plants(number, plants, request.scene);
    if (sampling.accuracy == campaign_.sampling) request.work = works_[number];
    return request;
}

std::vector<LitCanopy> Stand::light(const std::vector<std::size_t>& numbers,
                                    const Plants& plants,
                                    const Sampling& sampling,
                                    const Device& device,
                                    LightCue::Response& response,
                                    const ReportOptions& options) const {
    std::vector<CanopyRequest> requests;
    for (const std::size_t number : numbers) {
        requests.push_back(request(number, plants, sampling, response));
        requests.back().details.sunlit = options.sunlit;
    }
    std::vector<LitCanopy> canopies = LitCanopy::sharing_light(
        std::move(requests), device, options.clock, options.threads);
    if (cue_.is_any())
        response.observe(numbers.front(), canopies.front().scene(),
                         canopies.front().report());
    return canopies;
}

void Stand::report_each(const Plants& plants, const Sampling& sampling,
                        const Device& device, const TakeReport& take,
                        const ReportOptions& options) {
    prepare(device);
    LightCue::Response response(cue_);
    std::vector<std::vector<CanopyReport>> reports(scenarios_.size());
    for (std::size_t leader = 0; leader < scenarios_.size(); ++leader) {
        // The scenarios with the same light as the leader, and the leader.
        std::vector<std::size_t> members;
        for (std::size_t i = leader; i < scenarios_.size(); ++i)
            if (scenarios_[i].light == leader) members.push_back(i);
        if (members.empty()) continue;
        std::vector<std::vector<LitCanopy>> stages(members.size());
        for (std::size_t s = 0; s < scenarios_[leader].cases; ++s) {
            std::vector<std::size_t> numbers;
            for (const std::size_t i : members)
                numbers.push_back(scenarios_[i].first + s);
            std::vector<LitCanopy> lit =
                light(numbers, plants, sampling, device, response, options);
            for (std::size_t m = 0; m < members.size(); ++m)
                if (scenarios_[members[m]].season.is_any())
                    stages[m].push_back(std::move(lit[m]));
                else
                    reports[members[m]].push_back(lit[m].report());
        }
        for (std::size_t m = 0; m < members.size(); ++m) {
            if (stages[m].empty()) continue;
            // The season of all stages decides about their fluxes.
            const Season& season = scenarios_[members[m]].season;
            std::vector<CanopyReport>& of_stages = reports[members[m]];
            const auto soil = season.dry(stages[m]);
            for (const LitCanopy& stage : stages[m])
                of_stages.push_back(stage.report());
            season.add_to(soil, stages[m], of_stages);
        }
    }
    for (std::size_t i = 0; i < scenarios_.size(); ++i)
        for (std::size_t s = 0; s < reports[i].size(); ++s)
            take(cases_[scenarios_[i].first + s], std::move(reports[i][s]));
}

Outcome Stand::evaluate(const Plants& plants, const Sampling& sampling,
                        const Device& device) {
    std::vector<Outcome> outcomes;
    report_each(
        plants, sampling, device,
        [&](const Case& chosen, const CanopyReport& report) {
            outcomes.push_back(to_outcome(campaign_in(campaign_, chosen),
                                          chosen, plants.front(), report));
        });
    Outcome outcome = across_.combine(outcomes);
    IDEOTYPE_ENSURE(outcome.quantities.size() == schema_.measured.size());
    if (campaign_.water && campaign_.spec.water->limit > 0) {
        // Adds a margin of two standard errors: without it, the best of many
        // noisy plants would exceed the limit.
        constexpr double sure = 2;
        Estimate water =
            outcome.quantities[schema_.measured.offset("water_use")];
        if (campaign_.spec.soil) {
            const Estimate& more =
                outcome.quantities[schema_.measured.offset("soil_evaporation")];
            water = {water.mean + more.mean,
                     water.standard_error + more.standard_error};
        }
        outcome.violation +=
            std::max(0., (water.mean + sure * water.standard_error) /
                                 campaign_.spec.water->limit -
                             1);
    }
    return outcome;
}

RandomisedOutcome Stand::evaluate_by_randomisation(const Plants& plants,
                                                   const Sampling& sampling,
                                                   const Device& device) {
    std::vector<Outcome> outcomes;
    std::vector<std::vector<Outcome>> apart;  // [randomisation, case]
    report_each(
        plants, sampling, device,
        [&](const Case& chosen, const CanopyReport& report) {
            outcomes.push_back(to_outcome(campaign_in(campaign_, chosen),
                                          chosen, plants.front(), report));
            const std::vector<Randomised> quantities =
                measure_by_randomisation(report);
            const Outcome& all = outcomes.back();
            const std::size_t count = report.randomisations();
            apart.resize(count);
            for (std::size_t r = 0; r < count; ++r) {
                Outcome& one = apart[r].emplace_back(all);
                one.randomisations.clear();
                for (std::size_t k = 0; k < all.objectives.size(); ++k) {
                    const double value = all.randomisations.at(k * count + r);
                    one.objectives[k] = {value, 0};
                    one.randomisations.push_back(value);
                }
                for (std::size_t q = 0; q < quantities.size(); ++q) {
                    const std::vector<double>& values =
                        quantities[q].by_randomisation;
                    one.quantities[q] = {
                        values.empty()
                            ? std::numeric_limits<double>::quiet_NaN()
                            : values.at(r),
                        0};
                }
            }
        });
    RandomisedOutcome result{across_.combine(outcomes), {}};
    for (const std::vector<Outcome>& outcomes_of_one : apart) {
        std::vector<double>& values = result.quantities.emplace_back();
        for (const Estimate& x : across_.combine(outcomes_of_one).quantities)
            values.push_back(x.mean);
    }
    return result;
}

std::vector<SeasonState> Stand::season(const Plants& plants,
                                       const Sampling& sampling,
                                       const Device& device,
                                       const ControlDay& control) {
    prepare(device);
    LightCue::Response response(cue_);
    std::vector<LitCanopy> stages;
    for (std::size_t i = 0; i < scenarios_.front().cases; ++i)
        stages.push_back(std::move(
            light({i}, plants, sampling, device, response, {}).front()));
    return scenarios_.front().season.run(stages, control);
}

}  // namespace ideotype
