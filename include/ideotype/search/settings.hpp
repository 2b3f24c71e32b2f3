#pragma once

namespace ideotype {

//! Which optimizer searches.
enum class OptimizerKind { ga };

//! Settings of the genetic algorithm.
struct GaSettings {
    int elites = 2;      //!< parents that are carried over and re-evaluated
    int tournament = 2;  //!< contestants per selected parent
    double crossover_probability = 0.9;  //!< per couple
    double crossover_index = 15;         //!< of simulated binary crossover
    //! Expected number of mutated genes per child.
    double mutations_per_child = 1;
    double mutation_index = 20;  //!< of polynomial mutation
};

//! How a case is searched.
struct SearchSettings {
    OptimizerKind optimizer = OptimizerKind::ga;
    int population = 100;  //!< candidates that a generation usually has
    GaSettings ga;
};

}  // namespace ideotype
