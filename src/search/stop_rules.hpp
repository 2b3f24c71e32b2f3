// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "summary.hpp"

namespace ideotype {

//! The rules that end the evolution of a case; zero disables a rule.
struct StopRules {
    int generations = 200;
    int no_gain = 0;            //!< generations without a significant gain
    long long evaluations = 0;  //!< number of evaluated rows
    double wall_time = 0;       //!< wall time over all sessions [s]
};

//! The values that stop rules need from the committed generations of a history.
struct Progress {
    std::vector<GenerationSummary> generations;
    double wall_time = 0;  //!< wall time [s]
};

//! Name of the rule that ends a case after a number of generations.
inline constexpr const char* all_generations = "generations";

//! Returns the name of the first rule that ends the evolution, if any:
//! "generations", "no_gain", "evaluations" or "wall_time". Rule "no_gain" fits
//! a least-squares line to the means of objective 0 over `no_gain` generations.
//! It applies if the slope is less than twice its standard error, which follows
//! from the scatter about the line and so includes the noise between
//! generations. The rule waits while no plant meets all constraints. With
//! several objectives it uses the hypervolume, which must gain more than twice
//! its standard error.
//! @param sense whether objective 0 is maximised or minimised
std::optional<std::string> finished(const StopRules& rules,
                                    const Progress& progress, Sense sense);

}  // namespace ideotype
