// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace ideotype {

//! Which optimizer searches.
enum class OptimizerKind { ga, cma_es, nsga2, random, sobol };

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

//! Settings of CMA-ES.
struct CmaSettings {
    //! Where it begins, as a genome; empty: at the baseline.
    std::vector<double> start;
    //! Standard deviation at the beginning, relative to the range of a gene.
    double step = 0.2;
    //! Below this, relative to the range, along all axes, it has converged.
    double smallest_step = 1e-4;
    //! Searches that begin anew with twice the population after that.
    int restarts = 0;
    //! Whether learning rates follow the signal in its steps.
    bool adapts_learning_rates = false;
};

enum class SensitivityMethod {
    sobol,  //!< indices of variance
    morris  //!< elementary effects
};

//! What is one factor of a sensitivity study.
enum class Grouping {
    trait,  //!< all free genes of a trait together
    gene,
};

//! How the rows of a sensitivity study are chosen.
struct SensitivitySettings {
    SensitivityMethod method = SensitivityMethod::sobol;
    int samples = 1024;  //!< base samples, or trajectories of Morris
    int levels = 4;      //!< of Morris: values of each factor
    Grouping groups = Grouping::trait;
};

//! How a case is searched.
struct SearchSettings {
    OptimizerKind optimizer = OptimizerKind::ga;
    int population = 100;  //!< candidates that a generation usually has
    //! Rows that may be under way at the same time; 0: those of a generation.
    int window = 0;
    GaSettings ga;
    CmaSettings cma;
    //! That proposes the rows in place of an optimizer.
    std::optional<SensitivitySettings> design{};
    //! Of the hypervolume, by objective; empty: the worst of the beginning.
    std::vector<double> reference{};
};

}  // namespace ideotype
