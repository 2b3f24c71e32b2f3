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

//! The part of a history that stop rules need, after some committed
//! generations.
struct Progress {
    std::vector<GenerationSummary> generations;
    double wall_time = 0;  //!< wall time [s]
};

//! Name of the rule that ends a case after its generations.
inline constexpr const char* all_generations = "generations";

//! Returns the name of the first rule that ends the evolution, if any:
//! "generations", "no_gain", "evaluations" or "wall_time". There is no gain if
//! the slope of a least-squares line through the means of objective 0 over
//! `no_gain` generations is less than twice its standard error. The standard
//! error follows from the scatter about the line, which includes the noise of
//! each generation's new random numbers. While no plant meets all constraints
//! the rule waits. With several objectives the rule uses the hypervolume, whose
//! gain must exceed twice its standard error.
//! @param sense sense of objective 0
std::optional<std::string> finished(const StopRules& rules,
                                    const Progress& progress, Sense sense);

}  // namespace ideotype
