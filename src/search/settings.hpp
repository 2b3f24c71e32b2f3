// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/enum_names.hpp"
#include "ideotype/core/range.hpp"

namespace ideotype {

//! The kinds of optimizers.
enum class OptimizerKind { automatic, ga, cma_es, nsga2, atlas, random, sobol };

template <>
inline constexpr std::array enum_names<OptimizerKind>{
    EnumName{"auto", OptimizerKind::automatic},
    EnumName{"ga", OptimizerKind::ga},
    EnumName{"cma_es", OptimizerKind::cma_es},
    EnumName{"nsga2", OptimizerKind::nsga2},
    EnumName{"atlas", OptimizerKind::atlas},
    EnumName{"random", OptimizerKind::random},
    EnumName{"sobol", OptimizerKind::sobol}};

//! Settings of the genetic algorithm.
struct GaSettings {
    int elites = 2;                      //!< best parents that are re-evaluated
    int tournament = 2;                  //!< contestants per selected parent
    double crossover_probability = 0.9;  //!< probability per couple
    //! The distribution index of simulated binary crossover.
    double crossover_index = 15;
    double mutations_per_child = 1;  //!< expected mutated genes per child
    double mutation_index = 20;  //!< distribution index of polynomial mutation
};

enum class SensitivityMethod {
    sobol,  //!< variance-based indices
    morris  //!< elementary effects
};

//! The grouping of genes into factors of a sensitivity study.
enum class Grouping {
    trait,  //!< all free genes of a trait together
    gene,
};

//! The settings of a sensitivity study, which determine its rows.
struct SensitivitySettings {
    SensitivityMethod method = SensitivityMethod::sobol;
    int samples = 1024;  //!< base samples, or trajectories (Morris)
    int levels = 4;      //!< number of values of each factor (Morris)
    Grouping groups = Grouping::trait;
};

//! A feature by which an atlas divides plants into cells of equal width.
struct AtlasAxis {
    std::string quantity;  //!< name of the quantity, for example "lai"
    Range range{0, 1};
    int cells = 10;
};

//! Returns the number of cells of the grid that the axes form.
std::size_t count_cells(const std::vector<AtlasAxis>& axes);

//! The settings of the search of a case.
struct SearchSettings {
    OptimizerKind optimizer = OptimizerKind::automatic;
    int population = 100;  //!< usual number of plants per generation
    int streams = 1;       //!< independent searches that take turns
    GaSettings ga;
    std::vector<double> start;      //!< start of CMA-ES; empty: baseline
    std::vector<AtlasAxis> axes{};  //!< axes of an atlas
    //! Settings of a sensitivity study, which proposes the rows instead of an
    //! optimizer.
    std::optional<SensitivitySettings> design{};
    //! Reference point of the hypervolume, one value per objective. If empty,
    //! it consists of the worst values of the first generation.
    std::vector<double> reference{};
};

//! The number of rows in the design with which a race of `auto` begins, in
//! populations.
inline constexpr int auto_design = 3;

//! Returns the default number of plants per generation of an optimizer.
int usual_population(OptimizerKind optimizer, std::size_t free_genes);

//! Returns whether an optimizer uses CMA-ES.
constexpr bool uses_cma_es(OptimizerKind optimizer) {
    return optimizer == OptimizerKind::automatic ||
           optimizer == OptimizerKind::cma_es;
}

}  // namespace ideotype
