// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/quantities.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

//! Returns the tables [[TABLE.keys]] with the varied keys.
Table keys_table(const std::string& table, std::vector<KeyFactor>& factors) {
    const auto section_of = [=](KeyFactor& factor) {
        Section section(table + ".keys",
                        {{"key", &factor.key}, {"range", &factor.range}});
        section["key"].is_any_text = true;
        return section;
    };
    return list_of_tables<KeyFactor>("keys", section_of, factors).optional();
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

Section stop_section(StopRules& stop) {
    return {"stop",
            {{"generations", &stop.generations},
             {"no_gain", &stop.no_gain},
             {"evaluations", &stop.evaluations},
             {"wall_time", &stop.wall_time},
             {"failed_fraction", &stop.failed_fraction}}};
}

Section final_section(FinalRule& rule) {
    return {"final",
            {{"candidates", &rule.candidates},
             {"paths", &rule.sampling.paths},
             {"randomisations", &rule.sampling.randomisations}}};
}

}  // namespace

std::vector<Table> run_tables(Draft& draft) {
    Campaign& campaign = draft.campaign;
    AnswerLimits& limits = campaign.answer_limits;
    return {
        one_table(search_section(campaign.search))
            .with(keys_table("search", draft.searched), "keys")
            .with(list_of_tables<AtlasAxis>("axes", axis_section,
                                            campaign.search.axes)
                      .optional(),
                  "axes"),
        one_table(sensitivity_section(draft.design, draft.varied.has_traits))
            .left_out_if(!draft.is_study)
            .with(keys_table("sensitivity", draft.varied.keys), "keys"),
        one_table(stop_section(campaign.stop)),
        one_table(final_section(campaign.final_rule)),
        one_table({"parallel",
                   {{"deadline", &limits.deadline},
                    {"attempts", &limits.attempts}}})};
}

}  // namespace ideotype
