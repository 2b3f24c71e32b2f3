// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "summary.hpp"

namespace ideotype {

//! The rules that tell when a case has evolved enough. Zero switches a rule
//! off.
struct StopRules {
    int generations = 200;
    int no_gain = 0;  //!< generations over which no gain is told from none
    long long evaluations = 0;  //!< rows that were evaluated
    double wall_time = 0;       //!< sum over all sessions [s]
    //! Failures of one generation that end the case with an error.
    double failed_fraction = 0.5;
};

//! The part of a history that the stop rules look at, after some committed
//! generations.
struct Progress {
    std::vector<GenerationSummary> generations;
    double wall_time = 0;  //!< [s]
};

//! Returns the name of the first rule that ends the evolution, if any:
//! "generations", "no_gain", "evaluations" or "wall_time". There is no gain if
//! the slope of a straight line through the means of objective 0 over so many
//! generations, by least squares, is less than twice its standard error, which
//! follows from the scatter about the line: it contains the noise of random
//! numbers that each generation draws anew. Where no plant meets all
//! constraints the rule waits. With several objectives the rule looks at the
//! hypervolume, whose gain has to exceed twice its own standard error.
//! @param sense of objective 0
std::optional<std::string> finished(const StopRules& rules,
                                    const Progress& progress, Sense sense);

}  // namespace ideotype
