// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

Section light_section(Campaign& campaign) {
    Section keys{"light"};
    Accuracy& accuracy = campaign.sampling;
    const bool has_tolerance = accuracy.tolerance > 0;
    const bool has_climates = !campaign.climates.empty();
    const bool grows = std::ranges::any_of(
        campaign.climates, [](const auto& each) { return each.value.grows(); });
    keys.add_paths(accuracy,
                   "light paths per randomisation; with a tolerance at most")
        .trades({1024, 4096, 16384, 65536}, !has_tolerance);
    keys.add_randomisations(accuracy);
    keys.add("fields", accuracy.fields, {1, 256},
             "random fields among which the randomisations are divided; with "
             "several, standard errors contain how fields differ")
        .written_if(accuracy.fields != 1);
    // Greater errors tell nothing about a plant.
    keys.add("tolerance", accuracy.tolerance, {0, 0.1},
             "relative standard error of the leaves' light that is expected of "
             "each evaluation, with as few paths as that takes; 0: none, all "
             "paths")
        .defaults("0.008, or 0 if paths is given")
        .trades({0.02, 0.01, 0.005, 0.0025}, has_tolerance)
        .mistaken = {{"per cent", 0.01}};
    keys.add("band", campaign.bounded_band,
             {{"par", BoundedBand::par}, {"nir", BoundedBand::nir}},
             "of several wavebands the one in which the tolerance bounds the "
             "light of leaves; first hits of light are shared, and scattered "
             "light of others gets about as many paths")
        .written_if(campaign.has_nir);
    keys.add("sky", campaign.sky_model,
             {{"uniform", SkyModel::uniform},
              {"overcast", SkyModel::overcast},
              {"clear", SkyModel::clear}},
             "how the radiance of diffuse light is distributed: evenly, or as "
             "CIE overcast or clear skies");
    keys.add("dates", campaign.sun_dates, {1, 366},
             "of a climate: the suns of so many dates stand for all, the "
             "nearest for each hour; stages of plants that grow share them out")
        .written_if(has_climates)
        .trades({1, 2, 3, 6, 12}, has_climates);
    keys.add("stages", campaign.stages, {1, 40},
             "of plants that grow: ages at which the canopy is evaluated; "
             "hours between two of them are linear in thermal time")
        .written_if(grows)
        .trades({4, 7, 10, 20}, grows);
    return keys;
}

//! The names of all objectives, those of single components too.
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
    Section keys{"objective"};
    Campaign& campaign = draft.campaign;
    const std::vector<std::string> names = objectives_of(draft);
    keys.add("maximise", campaign.maximised,
             "any single number of the canopy: on a mean day light that leaves "
             "absorb, CO2 that they assimilate (net of their respiration while "
             "there is light) or carbon that is left (net of day and night, "
             "and of building leaves), per area of ground or of leaf; parts of "
             "the light; leaf area; \"NAME.net_assimilation\" is that of one "
             "component")
        .or_list()
        .one_of(names);
    keys.add("minimise", campaign.minimised,
             "the same; several objectives are for nsga2")
        .or_list()
        .defaults("[]")
        .allows("as maximise")
        .one_of(names);
    keys.add("weights", campaign.weights, {-1000, 1000},
             "what the plants that are bred, and then each [[component]], "
             "count in each objective; left out, objectives are those of all "
             "plants together")
        .optional_list("list of numbers", "none", "[1, 0.5]");
    keys.add("sole", campaign.sole, {1e-6, 1e6},
             "what the plants that are bred, and then each [[component]], have "
             "when they stand alone, in the unit of the objective: this is "
             "then the land equivalent ratio, the sum of what each has over "
             "what it has alone")
        .optional_list("list of numbers", "none", "[1.1, 0.9]");
    keys.add("sole_errors", campaign.sole_errors, {0, 1e6},
             "standard errors of `sole`, which `evaluate` adds to that of the "
             "ratio; all rows share them, so that differences have none of "
             "them")
        .optional_list("list of numbers", "none", "[0.002, 0.001]");
    keys.add("over", campaign.over,
             "axes whose entries are scenarios, not cases: each plant is "
             "evaluated in all of them")
        .or_list()
        .defaults("[]")
        .written_if(!campaign.over.empty())
        .one_of({"site", "day", "climate", "spacing"});
    keys.add("scenarios", campaign.across,
             {{"mean", Across::mean}, {"worst", Across::worst}},
             "what each objective is: the mean over scenarios, or that of the "
             "scenario where it is worst")
        .written_if(!campaign.over.empty());
    return keys;
}

Section constraint_section(TraitConstraint& limit) {
    Section keys{"constraints." + limit.trait};
    keys.add("step", limit.step, {0, 360},
             "largest between neighbouring leaves; 0: any");
    keys.add("total", limit.total, {0, 1e9}, "of all leaves");
    keys.add("falling", limit.is_falling,
             "whether no leaf may have more than the one below it");
    keys.add("distichous", limit.distichous, {0, 90, "deg"},
             "of azimuths: leaves alternate between the two sides of one "
             "plane, none further from it than this; 0: any");
    keys.add("range", limit.range, {-1e9, 1e9}, "of each leaf");
    keys.add("highest", limit.highest, {0, 40},
             "how many leaves the range limits, counted from the highest down; "
             "0: all");
    return keys;
}

}  // namespace

bool asks_for_assimilation(const Campaign& campaign) {
    return std::ranges::any_of(
        objectives_of(campaign), [](const ObjectiveEntry& objective) {
            return is_of_assimilation(objective.quantity);
        });
}

std::vector<Table> measured_tables(Draft& draft) {
    return {one_table(light_section(draft.campaign)),
            one_table(objective_section(draft))};
}

Table constraints_table(Constraints& constraints) {
    Section keys{"constraints"};
    keys.add("lai", constraints.lai, {0, 1000, "m2 m-2"},
             "leaf area over ground area; a narrow range fixes it")
        .like("[3.4, 3.5]");
    Table table = one_table(keys);
    for (TraitConstraint& limit : constraints.traits)
        table.with(one_table(constraint_section(limit))
                       .left_out_if(!constrains(limit)),
                   limit.trait);
    return table;
}

}  // namespace ideotype
