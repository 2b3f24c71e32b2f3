#include "schema.hpp"

namespace ideotype {

namespace {

constexpr double most_paths = 1 << 24;

//! Errors above this tell nothing about a plant.
Key relative_error(const std::string& name, double& value,
                   const std::string& meaning) {
    Key key = fraction(name, value, meaning);
    key.upper = 0.1;
    key.mistaken = {{"per cent", 0.01}};
    return key;
}

std::vector<Key> sampling_keys(Accuracy& sampling) {
    return {{.name = "paths",
             .value = &sampling.paths,
             .lower = 16,
             .upper = most_paths,
             .meaning = "light paths per randomisation"},
            {.name = "randomisations",
             .value = &sampling.randomisations,
             .lower = 2,
             .upper = 1024,
             .meaning = "independent repetitions; their spread gives the "
                        "standard error"}};
}

}  // namespace

Section light_section(Campaign& campaign) {
    Section section{"light", sampling_keys(campaign.sampling)};
    section.keys.front().meaning =
        "light paths per randomisation; with a tolerance at most";
    section.keys.push_back(relative_error(
        "tolerance", campaign.sampling.tolerance,
        "relative standard error of the leaves' light that is expected "
        "of each evaluation, with as few paths as that takes; 0: none, "
        "all paths"));
    section.keys.back().initial = "0.008, or 0 if paths is given";
    section.keys.push_back(relative_error(
        "first_tolerance", campaign.first_tolerance,
        "that of the first generation, from which it falls to that "
        "of the last one by an equal factor each; 0: all the same"));
    section.keys.push_back({.name = "sky",
                            .value = &campaign.sky_model,
                            .choices = {"uniform", "overcast", "clear"},
                            .meaning = "how the radiance of diffuse light is "
                                       "distributed: evenly, or as CIE "
                                       "overcast or clear skies"});
    return section;
}

Section objective_section(Campaign& campaign) {
    return {"objective",
            {{.name = "maximise",
              .value = &campaign.objective,
              .choices = {"absorbed_par", "absorbed_par_per_leaf_area"},
              .meaning = "light that leaves absorb in a day, per area of "
                         "ground or of leaf"}}};
}

Section constraints_section(Constraints& constraints) {
    const auto step = [](const std::string& name, const std::string& trait,
                         double& value, const std::string& unit, double most) {
        return Key{.name = name,
                   .value = &value,
                   .unit = unit,
                   .lower = 0,
                   .upper = most,
                   .meaning = "largest difference of " + trait +
                              " between neighbouring leaves; 0: any"};
    };
    return {"constraints",
            {{.name = "lai",
              .value = &constraints.lai,
              .unit = "m2 m-2",
              .lower = 0,
              .upper = 1000,
              .example = "[3.4, 3.5]",
              .meaning = "leaf area over ground area; a narrow range fixes "
                         "it"},
             step("length_step", "length", constraints.length_step, "m", 3),
             step("width_step", "width", constraints.width_step, "m", 0.5),
             step("insertion_angle_step", "insertion angle",
                  constraints.insertion_angle_step, "deg", 90),
             {.name = "erect_top",
              .value = &constraints.erect_top,
              .meaning = "whether no leaf may be flatter than the one below "
                         "it"}}};
}

Section search_section(SearchSettings& search) {
    return {"search",
            {{.name = "optimizer",
              .value = &search.optimizer,
              .choices = {"ga"},
              .meaning = "what proposes the candidates: ga, the genetic "
                         "algorithm"},
             {.name = "population",
              .value = &search.population,
              .lower = 2,
              .upper = 100000,
              .meaning = "plants per generation"},
             {.name = "elites",
              .value = &search.ga.elites,
              .lower = 0,
              .upper = 99999,
              .meaning = "best plants carried over and evaluated again; "
                         "fewer than the population"},
             {.name = "tournament",
              .value = &search.ga.tournament,
              .lower = 1,
              .upper = 100000,
              .meaning = "contestants per selected parent; at most the "
                         "population"},
             fraction("crossover_probability", search.ga.crossover_probability,
                      "per couple"),
             {.name = "crossover_index",
              .value = &search.ga.crossover_index,
              .lower = 0,
              .upper = 1000,
              .meaning = "of simulated binary crossover; larger: children "
                         "nearer to their parents"},
             {.name = "mutations_per_child",
              .value = &search.ga.mutations_per_child,
              .lower = 0,
              .upper = 160,
              .meaning = "expected number of mutated genes"},
             {.name = "mutation_index",
              .value = &search.ga.mutation_index,
              .lower = 0,
              .upper = 1000,
              .meaning = "of polynomial mutation; larger: smaller "
                         "changes"}}};
}

Section stop_section(StopRules& stop) {
    return {"stop",
            {{.name = "generations",
              .value = &stop.generations,
              .lower = 1,
              .upper = 1e6,
              .meaning = "at most; also the size of a history"},
             {.name = "stagnation",
              .value = &stop.stagnation,
              .lower = 0,
              .upper = 1e6,
              .meaning = "generations without a better mean fitness; 0: "
                         "off"},
             {.name = "evaluations",
              .value = &stop.evaluations,
              .lower = 0,
              .upper = 1e12,
              .meaning = "at most; 0: no limit"},
             {.name = "wall_time",
              .value = &stop.wall_time,
              .notation = Notation::duration,
              .unit = "s",
              .lower = 0,
              .upper = 1e9,
              .example = "\"12:00:00\"",
              .meaning = "of all sessions together; 0: no limit"},
             {.name = "target",
              .value = &stop.target,
              .lower = 0,
              .upper = 1e9,
              .meaning = "fitness that is enough, in the objective's unit; "
                         "0: off"},
             fraction("failed_fraction", stop.failed_fraction,
                      "share of a generation that ends the run with an error "
                      "when it fails; 0: any failure does")}};
}

Section final_section(FinalRule& rule) {
    Section section{
        "final",
        {{.name = "candidates",
          .value = &rule.candidates,
          .lower = 1,
          .upper = 1000,
          .meaning = "best plants that are evaluated again; at most "
                     "the population"}}};
    for (const Key& key : sampling_keys(rule.sampling))
        section.keys.push_back(key);
    return section;
}

Section parallel_section(AnswerLimits& limits) {
    return {"parallel",
            {{.name = "deadline",
              .value = &limits.deadline,
              .notation = Notation::duration,
              .unit = "s",
              .lower = 0.001,
              .upper = 1e9,
              .example = "\"00:10:00\"",
              .meaning = "after which an evaluation is given to another "
                         "worker; at least 20 times what the longest took so "
                         "far"},
             {.name = "attempts",
              .value = &limits.attempts,
              .lower = 1,
              .upper = 1000,
              .meaning = "that may miss the deadline before an evaluation "
                         "has failed"}}};
}

}  // namespace ideotype
