// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ideotype {

//! Which optimizer searches.
enum class OptimizerKind { automatic, ga, cma_es, nsga2, random, sobol };

//! Names of optimizers, in the order of their kinds.
inline const std::vector<std::string> optimizer_names{
    "auto", "ga", "cma_es", "nsga2", "random", "sobol"};

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
    //! Independent searches whose generations take turns.
    int streams = 1;
    GaSettings ga;
    //! Where CMA-ES begins, as a genome; empty: at the baseline.
    std::vector<double> start;
    //! Standard deviation of CMA-ES at the beginning, relative to the range of
    //! a gene.
    double step = 0.2;
    //! That proposes the rows in place of an optimizer.
    std::optional<SensitivitySettings> design{};
    //! Of the hypervolume, by objective; empty: the worst of the beginning.
    std::vector<double> reference{};
};

//! How many plants a generation of this optimizer usually has.
int usual_population(OptimizerKind optimizer, std::size_t free_genes);

//! Whether a distribution is adapted by CMA-ES.
inline bool uses_cma_es(const SearchSettings& settings) {
    return settings.optimizer == OptimizerKind::automatic ||
           settings.optimizer == OptimizerKind::cma_es;
}

}  // namespace ideotype
