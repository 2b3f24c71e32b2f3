// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

namespace {

//! A part of a campaign without which some quantities cannot be computed, and
//! whether it is missing.
struct Need {
    bool (*is_of)(const std::string& quantity);
    bool is_missing;
    const char* text;
};

//! Reports a quantity that this campaign does not compute.
//! @param use purpose of the quantity, such as "the objective"
void check_quantity(const ByBand<bool>& follows, const std::vector<Need>& needs,
                    const std::string& key, const std::string& use,
                    const std::string& name, const Problems& problems) {
    const std::string quantity = quantity_of(name);
    for (std::size_t b = 0; b < wavebands.size(); ++b)
        problems.rule({key},
                      !follows[b] && is_of_band(quantity, wavebands[b].name),
                      "{} {} needs [[band]] with name = \"{}\"; add it", use,
                      name, wavebands[b].name);
    for (const Need& each : needs)
        problems.rule({key}, each.is_missing && each.is_of(quantity),
                      "{} {} {}", use, name, each.text);
}

//! Checks that this campaign computes all objectives and axes of an atlas.
void check_quantities(const Spec& spec, const Problems& problems) {
    const std::vector<Need> needs{
        {is_of_growth, !plants_grow(spec),
         "needs plants that grow; add emergence to [[climate]]"},
        {is_of_panels, spec.panels.empty(), "needs panels; add [[panel]]"},
        {is_of_water, !spec.water, "needs leaves that transpire; add [water]"},
        {is_of_soil, !spec.soil, "needs soil that dries; add [soil]"},
        {is_of_grain,
         !spec.plant.crop.grain || !plants_grow(spec) ||
             !spec.components.empty(),
         "needs grain: plants that grow, alone, of a crop file with [grain]"},
        {is_of_prices, !spec.prices, "needs prices; add [prices]"},
        {is_of_lines, spec.feasibility.lines.traits.empty(),
         "is a distance from measured lines (this campaign has none); add "
         "[feasibility] with lines = \"FILE.toml\""},
        {is_of_two_components, spec.components.size() != 1,
         "compares two components, and there are not two; add or remove a "
         "[[component]]"}};
    for (const auto& [key, name] : objective_keys(spec))
        check_quantity(spec.plant.crop.follows, needs, key, "the objective",
                       name, problems);
    const std::vector<AtlasAxis>& axes = spec.search.axes;
    for (std::size_t i = 0; i < axes.size(); ++i)
        check_quantity(spec.plant.crop.follows, needs,
                       "search.axes[" + std::to_string(i) + "].quantity",
                       "the axis", axes[i].quantity, problems);
}

//! Checks the grid of an atlas. Other searches must not specify a grid.
void check_atlas(const SearchSpec& search, const Problems& problems) {
    constexpr double limit = 1000;
    const bool is_atlas = search.optimizer == OptimizerKind::atlas;
    const std::vector<AtlasAxis>& axes = search.axes;
    problems.rule(ProblemCode::missing, {"optimizer"}, is_atlas && axes.empty(),
                  "search.optimizer is \"atlas\" (which needs axes that "
                  "distinguish kinds of plants); add [[search.axes]]");
    problems.rule({"optimizer"}, !is_atlas && !axes.empty(),
                  "search.axes are given (only an atlas has them); use "
                  "search.optimizer = \"atlas\", or remove them");
    problems.rule({"streams"}, is_atlas && search.streams > 1,
                  "search.streams is {} (an atlas is one search); use 1",
                  search.streams);
    const auto key = [](const char* name, std::size_t axis) {
        return fmt::format("axes[{}].{}", axis, name);
    };
    double cells = 1;
    Keys cell_keys;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        cells *= axes[i].cells;
        cell_keys.push_back(key("cells", i));
        for (std::size_t j = 0; j < i; ++j)
            problems.rule(ProblemCode::duplicate,
                          {key("quantity", i), key("quantity", j)},
                          axes[i].quantity == axes[j].quantity,
                          "search.axes has {} twice; remove one of the two",
                          axes[i].quantity);
    }
    problems.rule(cell_keys, cells > limit,
                  "search.axes have {:.0f} cells together (the limit is {}); "
                  "use fewer, or a smaller number of axes",
                  cells, limit);
}

void check_objectives(const Spec& spec, const Problems& problems) {
    const std::vector<std::string>& maximised = spec.objective.maximised;
    const std::size_t count =
        maximised.size() + spec.objective.minimised.size();
    const std::size_t references = spec.search.reference.size();
    const bool is_pareto =
        spec.search.optimizer_or_usual() == OptimizerKind::nsga2;
    const std::string maximise = "objective.maximise",
                      minimise = "objective.minimise";
    for (const std::string& name : spec.objective.minimised)
        problems.rule(ProblemCode::duplicate, {minimise, maximise},
                      std::ranges::count(maximised, name) > 0,
                      "objective.minimise has {} (which is maximised too); "
                      "remove one of the two",
                      name);
    problems.rule({"search.reference", maximise, minimise},
                  references > 0 && references != count,
                  "search.reference has {} numbers (there are {} objectives); "
                  "give one for each, those that are maximised first",
                  references, count);
    problems.rule(ProblemCode::missing, {maximise, minimise}, count == 0,
                  "objective.maximise is empty (the search needs an "
                  "objective); name a quantity");
    problems.rule({"search.optimizer", maximise, minimise},
                  is_pareto && count == 1,
                  "search.optimizer is \"nsga2\" (which finds the Pareto front "
                  "of several objectives); name another in objective.minimise, "
                  "or use \"cma_es\"");
    problems.rule({minimise, maximise},
                  !is_pareto && count > 1 && !spec.is_study,
                  "there are {} objectives (only nsga2 finds their Pareto "
                  "front); use one, or search.optimizer = \"nsga2\"",
                  count);
    for (const auto& [key, name] : objective_keys(spec))
        problems.rule(
            {key},
            name == extinction && spec.field.boundary == Boundary::isolated,
            "the objective {} needs plants without end (light enters a plot "
            "from its sides); use \"fapar\"",
            extinction);
}

void check_scenarios(const Spec& spec, const Problems& problems) {
    const bool has_days = spec.climates.empty();
    const std::string wrong = has_days ? "climate" : "day";
    problems.rule({"objective.over"}, is_over(spec, wrong),
                  "objective.over has \"{}\" (this campaign has [[{}]]); use "
                  "that, or remove it",
                  wrong, has_days ? "day" : "climate");
    const ObjectiveSpec& objective = spec.objective;
    const bool is_probability = objective.across == Across::probability;
    problems.rule(ProblemCode::missing, {"objective.scenarios"},
                  is_probability && !objective.threshold,
                  "objective.scenarios is \"probability\" (of a value at or "
                  "above a threshold, which is missing); add "
                  "scenario_threshold");
    problems.rule({"objective.scenario_threshold", "objective.scenarios"},
                  !is_probability && objective.threshold.has_value(),
                  "objective.scenario_threshold is {} (only the scenarios "
                  "\"probability\" have one); remove it, or set scenarios",
                  objective.threshold.value_or(0));
    // A case that has only weightless scenarios would have no mean.
    const auto has_weight = [](const auto& list, const auto& weight) {
        return list.empty() || std::ranges::any_of(list, [&](const auto& each) {
                   return weight(each) > 0;
               });
    };
    problems.rule(
        {"site[0].weight"},
        !has_weight(spec.sites, [](const Site& x) { return x.weight; }),
        "no site has a weight above 0; give one to each that counts");
    problems.rule(
        {"climate[0].weights"},
        !has_weight(spec.climates,
                    [](const NamedClimate& x) { return x.value.weight(); }),
        "no climate has a weight above 0; give one to each that counts");
    problems.rule({"objective.over"},
                  spec.draws.empty() && is_over(spec, "draw"),
                  "objective.over has \"draw\" (this campaign has no "
                  "[[draw]]); add some, or remove it");
    problems.rule({"objective.over"},
                  !spec.draws.empty() && !is_over(spec, "draw"),
                  "there are [[draw]] tables (draws are scenarios of one "
                  "case); add \"draw\" to objective.over");
}

//! Reports populations and numbers of generations that are too small for a
//! search by CMA-ES.
void check_cma_es(const Spec& spec, const Problems& problems) {
    if (!uses_cma_es(spec.search.optimizer_or_usual())) return;
    const bool is_auto =
        spec.search.optimizer_or_usual() == OptimizerKind::automatic;
    // Name the optimizer if the user has not chosen it.
    const std::string who = spec.search.optimizer
                                ? ""
                                : "the optimizer is \"auto\", since "
                                  "search.optimizer is not given; ";
    const std::string other =
        spec.search.optimizer ? "" : ", or set search.optimizer = \"ga\"";
    // Each search needs at least four plants to rank.
    const int fewest = is_auto ? 8 : 4;
    const int population = spec.search.population_or_usual();
    problems.rule({"search.population"}, population < fewest,
                  "search.population is {} ({}CMA-ES ranks at least {} "
                  "plants); use {} or more, or leave it out{}",
                  population, who, fewest, fewest, other);
    // The rows of a history are limited by generations times plants.
    const int generations = spec.stop.generations;
    problems.rule({"stop.generations"}, is_auto && generations < auto_design,
                  "stop.generations is {} ({}a race of auto begins with {} "
                  "times search.population plants); use {} or more{}",
                  generations, who, auto_design, auto_design, other);
}

}  // namespace

void check_search(const Spec& spec, const Problems& problems) {
    const int population = spec.search.population_or_usual();
    const int generations = spec.stop.generations, gain = spec.stop.no_gain;
    const auto at_most = [&](const std::string& key, int value, int limit) {
        problems.rule({key, "search.population"}, value > limit,
                      "{} is {} (the population is {}); use {} or fewer", key,
                      value, population, limit);
    };
    at_most("search.elites", spec.search.ga.elites, population - 1);
    at_most("search.tournament", spec.search.ga.tournament, population);
    if (spec.search.axes.empty())
        at_most("final.candidates",
                spec.final.candidates.value_or(FinalRule{}.candidates),
                population);
    check_quantities(spec, problems);
    check_objectives(spec, problems);
    if (!spec.is_study) check_atlas(spec.search, problems.in("search"));
    constexpr int fewest = 5;
    problems.rule({"stop.no_gain"}, gain > 0 && gain < fewest,
                  "stop.no_gain is {} (too few generations for the error of a "
                  "slope); use {} or more, or 0",
                  gain, fewest);
    problems.rule({"stop.gain_left"},
                  spec.stop.gain_left > 0 && spec.search.optimizer_or_usual() !=
                                                 OptimizerKind::automatic,
                  "stop.gain_left is {} (its statement was tested for the "
                  "optimizer \"auto\" alone); use stop.no_gain, or set "
                  "search.optimizer = \"auto\"",
                  spec.stop.gain_left);
    check_scenarios(spec, problems);
    if (!spec.is_study) check_cma_es(spec, problems);
    constexpr double most_rows = std::numeric_limits<std::int32_t>::max();
    problems.rule({"stop.generations", "search.population"},
                  1. * population * generations > most_rows,
                  "stop.generations is {} (with a population of {} a history "
                  "would have more rows than {:.0f}); use {:.0f} or fewer",
                  generations, population, most_rows,
                  std::floor(most_rows / population));
}

void check_light(const LightSpec& light, bool assimilates,
                 const Problems& problems) {
    const int count = light.randomisations;
    constexpr int fewest = 8, fewest_in_field = 4, fewest_fields = 4;
    problems.rule({"randomisations", "tolerance"},
                  light.tolerance > 0 && count < fewest,
                  "light.randomisations is {} (too few to test whether a "
                  "tolerance is met); use {} or more",
                  count, fewest);
    problems.rule({"randomisations"},
                  light.fields == 1 && count < fewest_in_field && assimilates,
                  "light.randomisations is {} (too few for assimilation in one "
                  "field); use {} or more",
                  count, fewest_in_field);
    problems.rule({"fields", "randomisations"},
                  light.fields > 1 && light.fields < fewest_fields,
                  "light.fields is {} (too few to estimate differences between "
                  "fields); use 1, or {} or more",
                  light.fields, fewest_fields);
    problems.rule(
        {"fields", "randomisations"}, [&] { return count % light.fields != 0; },
        "light.fields is {} (the {} randomisations cannot be divided evenly "
        "among them); use a divisor of light.randomisations",
        light.fields, count);
}

}  // namespace ideotype
