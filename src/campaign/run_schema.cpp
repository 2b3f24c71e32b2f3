// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

//! Errors above this tell nothing about a plant.
constexpr double largest_error = 0.1;

Key relative_error(const std::string& name, double& value,
                   const std::string& meaning) {
    return Key(name, &value, meaning)
        .within(0, largest_error)
        .set(&Key::mistaken, std::vector<MistakenUnit>{{"per cent", 0.01}});
}

Key paths(Accuracy& accuracy, const std::string& meaning) {
    return Key("paths", &accuracy.paths, meaning).within(16, 1 << 24);
}

Key randomisations(Accuracy& accuracy) {
    return Key("randomisations", &accuracy.randomisations,
               "independent repetitions; their spread gives the standard error")
        .within(2, 1024);
}

Key duration(const std::string& name, double& value, double least,
             const std::string& example, const std::string& meaning) {
    return Key(name, &value, meaning)
        .within(least, 1e9, "s")
        .set(&Key::notation, Notation::duration)
        .like(example);
}

}  // namespace

Section light_section(Campaign& campaign) {
    const bool has_tolerance = campaign.sampling.tolerance > 0;
    const bool grows =
        std::any_of(campaign.climates.begin(), campaign.climates.end(),
                    [](const auto& each) { return each.value.grows(); });
    return {"light",
            {paths(campaign.sampling,
                   "light paths per randomisation; with a tolerance at most")
                 .trades({1024, 4096, 16384, 65536}, !has_tolerance),
             randomisations(campaign.sampling),
             Key("fields", &campaign.sampling.fields,
                 "random fields among which the randomisations are divided; "
                 "with several, standard errors contain how fields differ")
                 .within(1, 256)
                 .set(&Key::is_written, campaign.sampling.fields != 1),
             relative_error(
                 "tolerance", campaign.sampling.tolerance,
                 "relative standard error of the leaves' light that is "
                 "expected of each evaluation, with as few paths as that "
                 "takes; 0: none, all paths")
                 .set(&Key::initial, "0.008, or 0 if paths is given")
                 .trades({0.02, 0.01, 0.005, 0.0025}, has_tolerance),
             Key("band", choice(campaign.bounded_band),
                 "of several wavebands the one in which the tolerance bounds "
                 "the light of leaves; first hits of light are shared, and "
                 "scattered light of others gets about as many paths")
                 .one_of({"par", "nir"})
                 .set(&Key::is_written, campaign.has_nir),
             Key("sky", choice(campaign.sky_model),
                 "how the radiance of diffuse light is distributed: evenly, "
                 "or as CIE overcast or clear skies")
                 .one_of({"uniform", "overcast", "clear"}),
             Key("dates", &campaign.sun_dates,
                 "of a climate: the suns of so many dates stand for all, the "
                 "nearest for each hour; stages of plants that grow share "
                 "them out")
                 .within(1, 366)
                 .set(&Key::is_written, !campaign.climates.empty())
                 .trades({1, 2, 3, 6, 12}, !campaign.climates.empty()),
             Key("stages", &campaign.stages,
                 "of plants that grow: ages at which the canopy is evaluated; "
                 "hours between two of them are linear in thermal time")
                 .within(1, 40)
                 .set(&Key::is_written, grows)
                 .trades({4, 7, 10, 20}, grows)}};
}

namespace {

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

}  // namespace

Section objective_section(Draft& draft) {
    Campaign& campaign = draft.campaign;
    const std::vector<std::string> names = objectives_of(draft);
    return {"objective",
            {Key("maximise", &campaign.maximised,
                 "any single number of the canopy: on a mean day light that "
                 "leaves absorb, CO2 that they assimilate (net of their "
                 "respiration while there is light) or carbon that is left "
                 "(net of day and night, and of building leaves), per area of "
                 "ground or of leaf; parts of the light; leaf area; "
                 "\"NAME.net_assimilation\" is that of one component")
                 .set(&Key::count, any_count)
                 .one_of(names),
             Key("minimise", &campaign.minimised,
                 "the same; several objectives are for nsga2")
                 .set(&Key::count, any_count)
                 .set(&Key::initial, "[]")
                 .set(&Key::range, "as maximise")
                 .one_of(names),
             Key("weights", &campaign.weights,
                 "what the plants that are bred, and then each [[component]], "
                 "count in each objective; left out, objectives are those of "
                 "all plants together")
                 .within(-1000, 1000)
                 .set(&Key::count, any_count)
                 .set(&Key::type, "list of numbers")
                 .set(&Key::initial, "none")
                 .set(&Key::is_written, !campaign.weights.empty())
                 .like("[1, 0.5]"),
             Key("sole", &campaign.sole,
                 "what the plants that are bred, and then each [[component]], "
                 "have when they stand alone, in the unit of the objective: "
                 "this is then the land equivalent ratio, the sum of what each "
                 "has over what it has alone")
                 .within(1e-6, 1e6)
                 .set(&Key::count, any_count)
                 .set(&Key::type, "list of numbers")
                 .set(&Key::initial, "none")
                 .set(&Key::is_written, !campaign.sole.empty())
                 .like("[1.1, 0.9]"),
             Key("sole_errors", &campaign.sole_errors,
                 "standard errors of `sole`, which `evaluate` adds to that of "
                 "the ratio; all rows share them, so that differences have "
                 "none of them")
                 .within(0, 1e6)
                 .set(&Key::count, any_count)
                 .set(&Key::type, "list of numbers")
                 .set(&Key::initial, "none")
                 .set(&Key::is_written, !campaign.sole_errors.empty())
                 .like("[0.002, 0.001]"),
             Key("over", &campaign.over,
                 "axes whose entries are scenarios, not cases: each plant is "
                 "evaluated in all of them")
                 .set(&Key::count, any_count)
                 .set(&Key::initial, "[]")
                 .set(&Key::is_written, !campaign.over.empty())
                 .one_of({"site", "day", "climate", "spacing"}),
             Key("scenarios", choice(campaign.across),
                 "what each objective is: the mean over scenarios, or that of "
                 "the scenario where it is worst")
                 .set(&Key::is_written, !campaign.over.empty())
                 .one_of({"mean", "worst"})}};
}

bool asks_for_assimilation(const Campaign& campaign) {
    const std::vector<ObjectiveEntry> all = objectives_of(campaign);
    return std::any_of(all.begin(), all.end(),
                       [](const ObjectiveEntry& objective) {
                           return is_of_assimilation(objective.quantity);
                       });
}

namespace {

Table constraint_table(TraitConstraint& limit) {
    const Section section{
        "constraints." + limit.trait,
        {Key("step", &limit.step, "largest between neighbouring leaves; 0: any")
             .within(0, 360),
         Key("total", &limit.total, "of all leaves").within(0, 1e9),
         Key("falling", &limit.is_falling,
             "whether no leaf may have more than the one below it"),
         Key("distichous", &limit.distichous,
             "of azimuths: leaves alternate between the two sides of one "
             "plane, none further from it than this; 0: any")
             .within(0, 90, "deg"),
         Key("range", &limit.range, "of each leaf").within(-1e9, 1e9),
         Key("highest", &limit.highest,
             "how many leaves the range limits, counted from the highest "
             "down; 0: all")
             .within(0, 40)}};
    Table table = one_table(section);
    table.name = limit.trait;
    table.is_default = !constrains(limit);
    return table;
}

}  // namespace

Table constraints_table(Constraints& constraints) {
    Table table =
        one_table({"constraints",
                   {Key("lai", &constraints.lai,
                        "leaf area over ground area; a narrow range fixes it")
                        .within(0, 1000, "m2 m-2")
                        .like("[3.4, 3.5]")}});
    for (TraitConstraint& limit : constraints.traits)
        table.children.push_back(constraint_table(limit));
    return table;
}

namespace {

//! The tables [[TABLE.keys]] of keys that are varied.
Table keys_table(const std::string& table, std::vector<KeyFactor>& keys,
                 const std::string& range) {
    Table all = list_of_tables<KeyFactor>(
        "keys",
        [=](KeyFactor& factor) -> Section {
            return {
                table + ".keys",
                {Key("key", &factor.key,
                     "a number of field, spacing, panel, optics, "
                     "photosynthesis or plant.baseline that is varied")
                     .set(&Key::is_any_text, true)
                     .required("\"optics.soil_albedo\""),
                 Key("range", &factor.range, range).required("[0.05, 0.3]")}};
        },
        keys);
    all.is_optional = true;
    return all;
}

Section search_section(SearchSettings& search) {
    GaSettings& ga = search.ga;
    return {
        "search",
        {Key("optimizer", choice(search.optimizer),
             "what proposes the candidates: a race of two searches by CMA-ES "
             "with restarts, the genetic algorithm, a single CMA-ES, NSGA-II "
             "for several objectives, or without learning: chance or points of "
             "the Sobol' sequence")
             .one_of(optimizer_names),
         Key("population", &search.population, "plants per generation")
             .within(2, 100000)
             .set(&Key::initial,
                  "100; of CMA-ES 4 + 3 ln(free genes), of auto 2.5 times "
                  "that"),
         Key("streams", &search.streams,
             "independent searches whose generations take turns, so that many "
             "workers do not wait for the end of a generation; not of chance")
             .within(1, 1000),
         Key("elites", &ga.elites,
             "best plants carried over and evaluated again; fewer than "
             "the population")
             .within(0, 99999),
         Key("tournament", &ga.tournament,
             "contestants per selected parent; at most the population")
             .within(1, 100000),
         Key("crossover_probability", &ga.crossover_probability, "per couple")
             .within(0, 1),
         Key("crossover_index", &ga.crossover_index,
             "of simulated binary crossover; larger: children nearer to "
             "their parents")
             .within(0, 1000),
         Key("mutations_per_child", &ga.mutations_per_child,
             "expected number of mutated genes")
             .within(0, 160),
         Key("mutation_index", &ga.mutation_index,
             "of polynomial mutation; larger: smaller changes")
             .within(0, 1000),
         Key("start", &search.start,
             "of auto and CMA-ES: the plant to begin around, a number of each "
             "gene; see run --start; none: the baseline")
             .set(&Key::count, any_count)
             .set(&Key::initial, "[]")
             .set(&Key::is_written, !search.start.empty()),
         Key("step", &search.step,
             "of auto and CMA-ES: standard deviation around the start at the "
             "beginning, relative to the range of a gene; circular genes have "
             "half of it")
             .within(1e-6, 1),
         Key("reference", &search.reference,
             "of several objectives, in their order and units: the "
             "hypervolume of a generation is relative to it")
             .set(&Key::count, any_count)
             .set(&Key::is_written, !search.reference.empty())
             .set(&Key::type, "list of numbers")
             .set(&Key::initial, "the worst of each in generation 0")}};
}

}  // namespace

Table search_table(Draft& draft) {
    Table table = one_table(search_section(draft.campaign.search));
    table.children = {keys_table("search", draft.searched,
                                 "in which, beside the genes of the plant")};
    return table;
}

Table sensitivity_table(Draft& draft) {
    Variation& varied = draft.varied;
    SensitivitySettings& design = draft.design;
    Table table = one_table(
        {"sensitivity",
         {Key("method", choice(design.method),
              "Sobol' indices of the variance, first order and total, or "
              "elementary effects by Morris")
              .one_of({"sobol", "morris"}),
          Key("samples", &design.samples,
              "base samples of Sobol', best a power of two, each of 2 rows "
              "and one per factor; or trajectories of Morris, each of 1 row "
              "and one per factor")
              .within(4, 1 << 17)
              .set(&Key::initial, "1024; of morris 64"),
          Key("levels", &design.levels,
              "of Morris: values that each number takes; even")
              .within(2, 100),
          Key("groups", choice(design.groups),
              "what is one factor: all numbers of a trait, or each gene")
              .one_of({"trait", "gene"}),
          Key("traits", &varied.has_traits,
              "whether the traits of the case's trait set are varied")}});
    table.children = {
        keys_table("sensitivity", varied.keys, "in which, evenly")};
    table.is_default = !draft.is_study;
    return table;
}

Section stop_section(StopRules& stop) {
    return {"stop",
            {Key("generations", &stop.generations,
                 "at most; also the size of a history")
                 .within(1, 1e6),
             Key("no_gain", &stop.no_gain,
                 "generations over which a line through the means, or the "
                 "hypervolume, must rise by more than twice its standard "
                 "error; 0: off, else 5 or more")
                 .within(0, 1e6),
             Key("evaluations", &stop.evaluations, "at most; 0: no limit")
                 .within(0, 1e12),
             duration("wall_time", stop.wall_time, 0, "\"12:00:00\"",
                      "of all sessions together; 0: no limit"),
             Key("failed_fraction", &stop.failed_fraction,
                 "share of a generation that ends the run with an error when "
                 "it fails; 0: any failure does")
                 .within(0, 1)}};
}

Section final_section(FinalRule& rule) {
    return {"final",
            {Key("candidates", &rule.candidates,
                 "best plants that are evaluated again; at most the "
                 "population")
                 .within(1, 1000),
             paths(rule.sampling, "light paths per randomisation"),
             randomisations(rule.sampling)}};
}

Section parallel_section(AnswerLimits& limits) {
    return {"parallel",
            {duration("deadline", limits.deadline, 0.001, "\"00:10:00\"",
                      "after which an evaluation is given to another worker; "
                      "at least 20 times what the longest took so far"),
             Key("attempts", &limits.attempts,
                 "that may miss the deadline before an evaluation has failed")
                 .within(1, 1000)}};
}

}  // namespace ideotype
