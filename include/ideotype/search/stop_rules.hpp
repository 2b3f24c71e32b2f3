#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ideotype {

//! When a case has evolved enough. Zero switches a rule off.
struct StopRules {
    int generations = 200;
    int stagnation = 0;         //!< generations without a better mean fitness
    long long evaluations = 0;  //!< rows that were evaluated
    double wall_time = 0;       //!< of all sessions together [s]
    double target = 0;          //!< best fitness, in the objective's unit
    double failed_fraction = 0.5;  //!< of one generation: ends with an error
};

//! What the stop rules look at, after some committed generations.
struct Progress {
    std::vector<double> mean;  //!< mean fitness per generation
    std::vector<double> best;  //!< best fitness per generation
    long long evaluations = 0;
    double wall_time = 0;  //!< [s]
};

//! The name of the first rule that ends the evolution: "generations",
//! "stagnation", "evaluations", "wall_time" or "target". Stagnation looks at
//! the mean fitness, because the best of a generation is partly luck.
std::optional<std::string> finished(const StopRules& rules,
                                    const Progress& progress);

}  // namespace ideotype
