// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

namespace ideotype {

Key& Section::add_paths(Accuracy& accuracy, const std::string& meaning) {
    return add("paths", accuracy.paths, {16, 1 << 24}, meaning);
}

Key& Section::add_randomisations(Accuracy& accuracy) {
    return add("randomisations", accuracy.randomisations, {2, 1024},
               "independent repetitions; their spread gives the standard "
               "error");
}

namespace {

void add_duration(Section& keys, const std::string& name, double& value,
                  double least, const std::string& example,
                  const std::string& meaning) {
    keys.add(name, value, {least, 1e9, "s"}, meaning).like(example).notation =
        Notation::duration;
}

//! The tables [[TABLE.keys]] of keys that are varied.
Table keys_table(const std::string& table, std::vector<KeyFactor>& factors,
                 const std::string& range) {
    return list_of_tables<KeyFactor>(
               "keys",
               [=](KeyFactor& factor) {
                   Section keys{table + ".keys"};
                   keys.add("key", factor.key,
                            "a number of field, spacing, panel, optics, "
                            "photosynthesis or plant.baseline that is varied")
                       .required("\"optics.soil_albedo\"")
                       .is_any_text = true;
                   keys.add("range", factor.range, range)
                       .required("[0.05, 0.3]");
                   return keys;
               },
               factors)
        .optional();
}

Section search_section(SearchSettings& search) {
    Section keys{"search"};
    GaSettings& ga = search.ga;
    keys.add("optimizer", search.optimizer, optimizers,
             "what proposes the candidates: a race of two searches by CMA-ES "
             "with restarts, the genetic algorithm, a single CMA-ES, NSGA-II "
             "for several objectives, or without learning: chance or points of "
             "the Sobol' sequence");
    keys.add("population", search.population, {2, 100000},
             "plants per generation")
        .defaults(
            "100; of CMA-ES 4 + 3 ln(free genes), of auto 2.5 times that");
    keys.add("streams", search.streams, {1, 1000},
             "independent searches whose generations take turns, so that many "
             "workers do not wait for the end of a generation; not of chance");
    keys.add("elites", ga.elites, {0, 99999},
             "best plants carried over and evaluated again; fewer than the "
             "population");
    keys.add("tournament", ga.tournament, {1, 100000},
             "contestants per selected parent; at most the population");
    keys.add("crossover_probability", ga.crossover_probability, {0, 1},
             "per couple");
    keys.add("crossover_index", ga.crossover_index, {0, 1000},
             "of simulated binary crossover; larger: children nearer to their "
             "parents");
    keys.add("mutations_per_child", ga.mutations_per_child, {0, 160},
             "expected number of mutated genes");
    keys.add("mutation_index", ga.mutation_index, {0, 1000},
             "of polynomial mutation; larger: smaller changes");
    keys.add("start", search.start,
             "of auto and CMA-ES: the plant to begin around, a number of each "
             "gene; see run --start; none: the baseline")
        .optional_list("", "[]", "");
    keys.add("step", search.step, {1e-6, 1},
             "of auto and CMA-ES: standard deviation around the start at the "
             "beginning, relative to the range of a gene; circular genes have "
             "half of it");
    keys.add("reference", search.reference,
             "of several objectives, in their order and units: the hypervolume "
             "of a generation is relative to it")
        .optional_list("list of numbers", "the worst of each in generation 0",
                       "");
    return keys;
}

Section sensitivity_section(SensitivitySettings& design, bool& has_traits) {
    Section keys{"sensitivity"};
    keys.add("method", design.method,
             {{"sobol", SensitivityMethod::sobol},
              {"morris", SensitivityMethod::morris}},
             "Sobol' indices of the variance, first order and total, or "
             "elementary effects by Morris");
    keys.add("samples", design.samples, {4, 1 << 17},
             "base samples of Sobol', best a power of two, each of 2 rows and "
             "one per factor; or trajectories of Morris, each of 1 row and one "
             "per factor")
        .defaults("1024; of morris 64");
    keys.add("levels", design.levels, {2, 100},
             "of Morris: values that each number takes; even");
    keys.add("groups", design.groups,
             {{"trait", Grouping::trait}, {"gene", Grouping::gene}},
             "what is one factor: all numbers of a trait, or each gene");
    keys.add("traits", has_traits,
             "whether the traits of the case's trait set are varied");
    return keys;
}

Section stop_section(StopRules& stop) {
    Section keys{"stop"};
    keys.add("generations", stop.generations, {1, 1e6},
             "at most; also the size of a history");
    keys.add("no_gain", stop.no_gain, {0, 1e6},
             "generations over which a line through the means, or the "
             "hypervolume, must rise by more than twice its standard error; 0: "
             "off, else 5 or more");
    keys.add("evaluations", stop.evaluations, {0, 1e12},
             "at most; 0: no limit");
    add_duration(keys, "wall_time", stop.wall_time, 0, "\"12:00:00\"",
                 "of all sessions together; 0: no limit");
    keys.add("failed_fraction", stop.failed_fraction, {0, 1},
             "share of a generation that ends the run with an error when it "
             "fails; 0: any failure does");
    return keys;
}

Section final_section(FinalRule& rule) {
    Section keys{"final"};
    keys.add("candidates", rule.candidates, {1, 1000},
             "best plants that are evaluated again; at most the population");
    keys.add_paths(rule.sampling, "light paths per randomisation");
    keys.add_randomisations(rule.sampling);
    return keys;
}

Section parallel_section(AnswerLimits& limits) {
    Section keys{"parallel"};
    add_duration(keys, "deadline", limits.deadline, 0.001, "\"00:10:00\"",
                 "after which an evaluation is given to another worker; at "
                 "least 20 times what the longest took so far");
    keys.add("attempts", limits.attempts, {1, 1000},
             "that may miss the deadline before an evaluation has failed");
    return keys;
}

}  // namespace

std::vector<Table> run_tables(Draft& draft) {
    Campaign& campaign = draft.campaign;
    Variation& varied = draft.varied;
    return {
        one_table(search_section(campaign.search))
            .with(keys_table("search", draft.searched,
                             "in which, beside the genes of the plant"),
                  "keys"),
        one_table(sensitivity_section(draft.design, varied.has_traits))
            .left_out_if(!draft.is_study)
            .with(keys_table("sensitivity", varied.keys, "in which, evenly"),
                  "keys"),
        one_table(stop_section(campaign.stop)),
        one_table(final_section(campaign.final_rule)),
        one_table(parallel_section(campaign.answer_limits))};
}

}  // namespace ideotype
