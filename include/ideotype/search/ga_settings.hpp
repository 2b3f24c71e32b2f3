#pragma once

namespace ideotype {

//! Settings of the genetic algorithm.
struct GaSettings {
    int population = 100;
    int elites = 2;      //!< parents that are carried over and re-evaluated
    int tournament = 2;  //!< contestants per selected parent
    double crossover_probability = 0.9;  //!< per couple
    double crossover_index = 15;         //!< of simulated binary crossover
    //! Expected number of mutated genes per child.
    double mutations_per_child = 1;
    double mutation_index = 20;  //!< of polynomial mutation
};

//! When a case has evolved enough. Zero switches a rule off.
struct StopRules {
    int generations = 200;
    int stagnation = 0;         //!< generations without a better mean fitness
    long long evaluations = 0;  //!< rows that were evaluated
    double wall_time = 0;       //!< of all sessions together [s]
    double target = 0;          //!< best fitness, in the objective's unit
    double failed_fraction = 0.5;  //!< of one generation: ends with an error
};

}  // namespace ideotype
