#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/search/ga_settings.hpp"

namespace ideotype {

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
