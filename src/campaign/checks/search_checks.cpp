// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

namespace {

//! A part of a campaign that some quantities need, and whether it is missing.
struct Need {
    bool (*is_of)(const std::string& quantity);
    bool is_missing;
    const char* text;
};

//! Reports a quantity that this canopy does not have.
//! @param use purpose of the quantity, such as "the objective"
void check_quantity(const ByBand<bool>& follows, const std::vector<Need>& needs,
                    const std::string& key, const std::string& use,
                    const std::string& name, const Problems& problems) {
    for (std::size_t b = 0; b < wavebands.size(); ++b)
        if (problems.usable(key) && !follows[b] &&
            is_of_band(quantity_of(name), wavebands[b].name))
            problems.add(key, "{} {} needs [[band]] with name = \"{}\"; add it",
                         use, name, wavebands[b].name);
    for (const Need& each : needs)
        if (problems.usable(key) && each.is_missing &&
            each.is_of(quantity_of(name)))
            problems.add(key, "{} {} {}", use, name, each.text);
}

//! Checks that the canopy has the objectives and the axes of an atlas.
void check_quantities(const Spec& spec, const Problems& problems) {
    const std::vector<Need> needs{
        {is_of_growth, !plants_grow(spec),
         "needs plants that grow; add emergence to [[climate]]"},
        {is_of_panels, spec.panels.empty(), "needs panels; add [[panel]]"},
        {is_of_water, !spec.water, "needs leaves that transpire; add [water]"},
        {is_of_lines, spec.feasibility.lines.traits.empty(),
         "is a distance from measured lines (this campaign has none); add "
         "[feasibility] with lines = \"FILE.toml\""},
        {is_of_two_components, spec.components.size() != 1,
         "compares two components, and there are not two; add or remove a "
         "[[component]]"}};
    for (const auto& [key, name] : objective_keys(spec, problems))
        check_quantity(spec.plant.crop.follows, needs, key, "the objective",
                       name, problems);
    const std::vector<AtlasAxis>& axes = spec.search.axes;
    for (std::size_t i = 0; i < axes.size(); ++i)
        check_quantity(spec.plant.crop.follows, needs,
                       "search.axes[" + std::to_string(i) + "].quantity",
                       "the axis", axes[i].quantity, problems);
}

//! Checks the grid of an atlas, which other searches must not have.
void check_atlas(const SearchSpec& search, const Problems& problems) {
    constexpr std::size_t most = 1000;
    const bool is_atlas = search.optimizer == OptimizerKind::atlas;
    if (!problems.usable({"optimizer", "streams"})) return;
    if (is_atlas && search.axes.empty())
        problems.add("optimizer",
                     "search.optimizer is \"atlas\" (which needs to know what "
                     "tells kinds of plants apart); add [[search.axes]]");
    if (!is_atlas && !search.axes.empty())
        problems.add("optimizer",
                     "search.axes are there (only an atlas has them); use "
                     "search.optimizer = \"atlas\", or remove them");
    if (is_atlas && search.streams > 1)
        problems.add("streams",
                     "search.streams is {} (an atlas is one search); use 1",
                     search.streams);
    double cells = 1;
    for (std::size_t i = 0; i < search.axes.size(); ++i) {
        const Problems own = problems.in("axes", i);
        if (!own.usable({"quantity", "range", "cells"})) return;
        cells *= search.axes[i].cells;
        for (std::size_t j = 0; j < i; ++j)
            if (search.axes[j].quantity == search.axes[i].quantity)
                own.add("quantity",
                        "search.axes has {} twice; remove one of the two",
                        search.axes[i].quantity);
    }
    if (cells > static_cast<double>(most))
        problems.in("axes", 0).add(
            "cells",
            "search.axes have {:.0f} cells together (the limit is {}); use "
            "fewer, or a smaller number of axes",
            cells, most);
}

void check_objectives(const Spec& spec, bool is_study,
                      const Problems& problems) {
    if (!problems.usable({"objective.maximise", "objective.minimise"})) return;
    const std::size_t count =
        spec.objective.maximised.size() + spec.objective.minimised.size();
    for (const std::string& each : spec.objective.minimised)
        if (std::ranges::count(spec.objective.maximised, each) > 0)
            problems.add("objective.minimise",
                         "objective.minimise has {} (which is maximised too); "
                         "remove one of the two",
                         each);
    if (spec.field.boundary == Boundary::isolated)
        for (const auto& [key, name] : objective_keys(spec, problems))
            if (name == extinction)
                problems.add(key,
                             "the objective {} needs plants without end (light "
                             "enters a plot from its sides); use \"fapar\"",
                             extinction);
    const std::vector<double>& reference = spec.search.reference;
    if (!reference.empty() && reference.size() != count &&
        problems.usable({"search.reference"}))
        problems.add("search.reference",
                     "search.reference has {} numbers (there are {} "
                     "objectives); give one for each, those that are maximised "
                     "first",
                     reference.size(), count);
    const bool is_pareto =
        spec.search.optimizer_or_usual() == OptimizerKind::nsga2;
    if (count == 0)
        problems.add("objective.maximise",
                     "objective.maximise is empty (nothing would be searched "
                     "for); name a quantity");
    else if (is_pareto && count == 1)
        problems.add("search.optimizer",
                     "search.optimizer is \"nsga2\" (which finds a front of "
                     "several objectives); name another in objective.minimise, "
                     "or use \"cma_es\"");
    else if (!is_pareto && count > 1 && !is_study)
        problems.add("objective.minimise",
                     "there are {} objectives (only nsga2 finds a front of "
                     "several); use one, or search.optimizer = \"nsga2\"",
                     count);
}

void check_scenarios(const Spec& spec, const Problems& problems) {
    if (!problems.usable({"objective.over"})) return;
    const bool has_days = spec.climates.empty();
    const std::string wrong = has_days ? "climate" : "day";
    if (is_over(spec, wrong))
        problems.add("objective.over",
                     "objective.over has \"{}\" (this campaign has [[{}]]); "
                     "use that, or remove it",
                     wrong, has_days ? "day" : "climate");
}

void check_stop(const StopRules& stop, const Problems& problems) {
    constexpr int fewest = 5;
    if (stop.no_gain > 0 && stop.no_gain < fewest)
        problems.add("stop.no_gain",
                     "stop.no_gain is {} (too few generations for the error of "
                     "a slope); use {} or more, or 0",
                     stop.no_gain, fewest);
}

//! Reports populations and numbers of generations that are too small for a
//! search by CMA-ES.
void check_cma_es(const Spec& spec, const Problems& problems) {
    if (!uses_cma_es(spec.search.optimizer_or_usual())) return;
    const bool is_auto =
        spec.search.optimizer_or_usual() == OptimizerKind::automatic;
    // Campaigns that name no optimizer may never have heard of this one.
    const std::string who = spec.search.optimizer
                                ? ""
                                : "the search is by \"auto\", since "
                                  "search.optimizer is not given; ";
    const std::string other =
        spec.search.optimizer ? "" : ", or set search.optimizer = \"ga\"";
    // Each search needs at least four plants to rank.
    const int fewest = is_auto ? 8 : 4;
    const int population = spec.search.population_or_usual();
    if (problems.usable({"search.population"}) && population < fewest)
        problems.add("search.population",
                     "search.population is {} ({}CMA-ES ranks at least {} "
                     "plants); use {} or more, or leave it out{}",
                     population, who, fewest, fewest, other);
    // A history has as many rows as its generations have plants.
    const int generations = spec.stop.generations;
    if (is_auto && problems.usable({"stop.generations"}) &&
        generations < auto_design)
        problems.add("stop.generations",
                     "stop.generations is {} ({}the first generation of auto "
                     "has three times search.population plants, so that "
                     "nothing would be evaluated); use {} or more{}",
                     generations, who, auto_design, other);
}

}  // namespace

void check_search(const Spec& spec, const Problems& problems) {
    const int population = spec.search.population_or_usual();
    const bool has_population = problems.usable({"search.population"});
    const auto at_most = [&](const std::string& key, int value, int most) {
        if (has_population && problems.usable(key) && value > most)
            problems.add(key,
                         "{} is {} (the population is {}); use {} or fewer",
                         key, value, population, most);
    };
    check_quantities(spec, problems);
    check_objectives(spec, spec.is_study, problems);
    if (!spec.is_study) check_atlas(spec.search, problems.in("search"));
    check_stop(spec.stop, problems);
    check_scenarios(spec, problems);
    if (!spec.is_study) check_cma_es(spec, problems);
    constexpr double most_rows = std::numeric_limits<std::int32_t>::max();
    const int generations = spec.stop.generations;
    if (problems.usable({"search.population", "stop.generations"}) &&
        1. * population * generations > most_rows)
        problems.add("stop.generations",
                     "stop.generations is {} (with a population of {} a "
                     "history would have more rows than {:.0f}); use {:.0f} or "
                     "fewer",
                     generations, population, most_rows,
                     std::floor(most_rows / population));
    at_most("search.elites", spec.search.ga.elites, population - 1);
    at_most("search.tournament", spec.search.ga.tournament, population);
    if (spec.search.axes.empty())
        at_most("final.candidates",
                spec.final.candidates.value_or(FinalRule{}.candidates),
                population);
}

void check_light(const LightSpec& light, bool assimilates,
                 const Problems& problems) {
    if (!problems.usable({"tolerance"})) return;
    const bool has_randomisations = problems.usable({"randomisations"});
    constexpr int fewest = 8;
    if (light.tolerance > 0 && has_randomisations &&
        light.randomisations < fewest)
        problems.add("randomisations",
                     "light.randomisations is {} (too few to tell whether a "
                     "tolerance is met); use {} or more",
                     light.randomisations, fewest);
    constexpr int fewest_in_field = 4;
    if (light.fields == 1 && light.randomisations < fewest_in_field &&
        assimilates && has_randomisations)
        problems.add("randomisations",
                     "light.randomisations is {} (too few for assimilation in "
                     "one field); use {} or more",
                     light.randomisations, fewest_in_field);
    constexpr int fewest_fields = 4;
    if (!problems.usable({"fields", "randomisations"}) || light.fields == 1)
        return;
    if (light.fields < fewest_fields)
        problems.add("fields",
                     "light.fields is {} (too few to tell how fields differ); "
                     "use 1, or {} or more",
                     light.fields, fewest_fields);
    else if (light.randomisations % light.fields != 0)
        problems.add(
            "fields",
            "light.fields is {} (the {} randomisations cannot be divided "
            "evenly among them); use a divisor of light.randomisations",
            light.fields, light.randomisations);
}

}  // namespace ideotype
