// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

Table keys_table(const std::string& table, std::vector<KeyFactor>& factors) {
    const auto section_of = [=](KeyFactor& factor) {
        Section section(table + ".keys",
                        {{"key", &factor.key}, {"range", &factor.range}});
        section["key"].is_any_text = true;
        return section;
    };
    return list_of_tables("keys", section_of, factors).optional();
}

Section axis_section(AtlasAxis& axis) {
    Section section("search.axes", {{"quantity", &axis.quantity},
                                    {"range", &axis.range},
                                    {"cells", &axis.cells}});
    section["quantity"].one_of(objective_names());
    return section;
}

Section search_section(SearchSettings& search) {
    GaSettings& ga = search.ga;
    Section section("search",
                    {{"optimizer", choice(search.optimizer, optimizers)},
                     {"population", &search.population},
                     {"streams", &search.streams},
                     {"elites", &ga.elites},
                     {"tournament", &ga.tournament},
                     {"crossover_probability", &ga.crossover_probability},
                     {"crossover_index", &ga.crossover_index},
                     {"mutations_per_child", &ga.mutations_per_child},
                     {"mutation_index", &ga.mutation_index},
                     {"start", &search.start},
                     {"step", &search.step},
                     {"reference", &search.reference}});
    for (const char* key : {"start", "reference"}) section[key].optional_list();
    return section;
}

Section sensitivity_section(SensitivitySettings& design, bool& has_traits) {
    return {"sensitivity",
            {{"method",
              choice(design.method, {{"sobol", SensitivityMethod::sobol},
                                     {"morris", SensitivityMethod::morris}})},
             {"samples", &design.samples},
             {"levels", &design.levels},
             {"groups", choice(design.groups, {{"trait", Grouping::trait},
                                               {"gene", Grouping::gene}})},
             {"traits", &has_traits}}};
}

Section light_section(Campaign& campaign) {
    Accuracy& accuracy = campaign.sampling;
    Section section(
        "light",
        {{"paths", &accuracy.paths},
         {"randomisations", &accuracy.randomisations},
         {"fields", &accuracy.fields},
         {"tolerance", &accuracy.tolerance},
         {"band", &campaign.bounded_band},
         {"sky", choice(campaign.sky_model, {{"uniform", SkyModel::uniform},
                                             {"overcast", SkyModel::overcast},
                                             {"clear", SkyModel::clear}})},
         {"dates", &campaign.sun_dates},
         {"stages", &campaign.stages}});
    const bool has_tolerance = accuracy.tolerance > 0;
    const bool has_climates = !campaign.climates.empty();
    const bool grows = plants_grow(campaign);
    section["paths"].trades({1024, 4096, 16384, 65536}, !has_tolerance);
    section["fields"].written_if(accuracy.fields != 1);
    section["tolerance"]
        .trades({0.02, 0.01, 0.005, 0.0025}, has_tolerance)
        .mistaken = {{"per cent", 0.01}};
    section["band"].written_if(std::ranges::count(campaign.follows, true) > 1);
    section["dates"]
        .written_if(has_climates)
        .trades({1, 2, 3, 6, 12}, has_climates);
    section["stages"].written_if(grows).trades({4, 7, 10, 20}, grows);
    return section;
}

//! Returns the names of all objectives, including those of components.
std::vector<std::string> objectives_of(const Draft& draft) {
    std::vector<std::string> names = objective_names();
    if (draft.components.empty()) return names;
    std::vector<std::string> components{draft.campaign.crop.baseline.name};
    for (const std::shared_ptr<Draft>& each : draft.components)
        components.push_back(each->campaign.name);
    for (const std::string& component : components)
        for (const std::string& quantity : additive_objectives())
            names.push_back(fmt::format("{}.{}", component, quantity));
    return names;
}

Section objective_section(Draft& draft) {
    Campaign& campaign = draft.campaign;
    Section section(
        "objective",
        {{"maximise", &campaign.maximised},
         {"minimise", &campaign.minimised},
         {"weights", &campaign.weights},
         {"sole", &campaign.sole},
         {"sole_errors", &campaign.sole_errors},
         {"over", &campaign.over},
         {"scenarios", choice(campaign.across, {{"mean", Across::mean},
                                                {"worst", Across::worst}})}});
    const std::vector<std::string> names = objectives_of(draft);
    section["maximise"].one_of(names).written_if(!campaign.maximised.empty());
    section["minimise"].one_of(names);
    for (const char* key : {"weights", "sole", "sole_errors"})
        section[key].optional_list();
    for (const char* key : {"over", "scenarios"})
        section[key].written_if(!campaign.over.empty());
    return section;
}

Section constraint_section(TraitConstraint& limit) {
    return {"constraints." + limit.trait,
            {{"step", &limit.step},
             {"total", &limit.total},
             {"falling", &limit.is_falling},
             {"distichous", &limit.distichous},
             {"range", &limit.range},
             {"highest", &limit.highest}},
            "constraints.TRAIT"};
}

}  // namespace

std::vector<Table> run_tables(Draft& draft) {
    Campaign& campaign = draft.campaign;
    StopRules& stop = campaign.stop;
    FinalRule& final = campaign.final_rule;
    AnswerLimits& limits = campaign.answer_limits;
    return {
        one_table(search_section(campaign.search))
            .with(keys_table("search", draft.searched), "keys")
            .with(list_of_tables("axes", axis_section, campaign.search.axes)
                      .optional(),
                  "axes"),
        one_table(sensitivity_section(draft.design, draft.varied.has_traits))
            .left_out_if(!draft.is_study)
            .with(keys_table("sensitivity", draft.varied.keys), "keys"),
        one_table({"stop",
                   {{"generations", &stop.generations},
                    {"no_gain", &stop.no_gain},
                    {"evaluations", &stop.evaluations},
                    {"wall_time", &stop.wall_time},
                    {"failed_fraction", &stop.failed_fraction}}}),
        one_table({"final",
                   {{"candidates", &final.candidates},
                    {"paths", &final.sampling.paths},
                    {"randomisations", &final.sampling.randomisations}}}),
        one_table({"parallel",
                   {{"deadline", &limits.deadline},
                    {"attempts", &limits.attempts}}})};
}

bool asks_for(const Campaign& campaign, bool (*is_of)(const std::string&)) {
    return std::ranges::any_of(objectives_of(campaign), is_of,
                               &ObjectiveEntry::quantity) ||
           std::ranges::any_of(campaign.search.axes, is_of,
                               &AtlasAxis::quantity);
}

bool asks_for_assimilation(const Campaign& campaign) {
    return asks_for(campaign, is_of_assimilation);
}

std::vector<Table> measured_tables(Draft& draft) {
    return {one_table(light_section(draft.campaign)),
            one_table(objective_section(draft))};
}

Table constraints_table(Constraints& constraints) {
    Table table = one_table({"constraints", {{"lai", &constraints.lai}}});
    for (TraitConstraint& limit : constraints.traits)
        table.with(one_table(constraint_section(limit))
                       .left_out_if(!constrains(limit)),
                   limit.trait);
    return table;
}

}  // namespace ideotype
