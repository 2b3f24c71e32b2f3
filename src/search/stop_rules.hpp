// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>
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
    //! Smallest gain of as many further evaluations, as a share of the gain so
    //! far; see gain_left().
    double gain_left = 0;
};

//! The values that stop rules need from the committed generations of a history.
struct Progress {
    std::vector<GenerationSummary> generations;
    double wall_time = 0;  //!< wall time [s]
    //! Objective 0 of the first plant, the baseline; NaN if unknown.
    double baseline = std::numeric_limits<double>::quiet_NaN();
};

//! What a search for one objective gained, in the unit of the objective.
struct GainLeft {
    double so_far = 0;  //!< mean of the last generations minus the baseline
    //! Gain of as many further evaluations, which 90 % of searches do not
    //! exceed.
    double most = 0;
};

//! Returns what a search gained and an upper bound of what as many further
//! evaluations gain. Gains diminish: twice the evaluations gain about as much
//! each time, or less. The bound is therefore the rise of the means since half
//! of the evaluations, or a tenth of its standard error if that is more, times
//! a factor. The factor was calibrated with 20 searches by `auto`, and 60
//! others tested it (analysis/study/gain_left.py). Returns nothing with fewer
//! than 250 evaluations, as long as no plant meets all constraints, or if the
//! baseline is unknown.
std::optional<GainLeft> gain_left(
    std::span<const GenerationSummary> generations, double baseline,
    Sense sense);

//! Name of the rule that ends a case after a number of generations.
inline constexpr const char* all_generations = "generations";

//! Returns the name of the first rule that ends the evolution, if any:
//! "generations", "no_gain", "gain_left", "evaluations" or "wall_time". Rule
//! "no_gain" fits a least-squares line to the means of objective 0 over
//! `no_gain` generations. It applies if the slope is less than twice its
//! standard error, which follows from the scatter about the line and so
//! includes the noise between generations. The rule waits while no plant meets
//! all constraints. With several objectives it uses the hypervolume, which must
//! gain more than twice its standard error.
//! @param sense whether objective 0 is maximised or minimised
std::optional<std::string> finished(const StopRules& rules,
                                    const Progress& progress, Sense sense);

}  // namespace ideotype
