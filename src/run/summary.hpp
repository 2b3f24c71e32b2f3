// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bounds.hpp"
#include "campaign/campaign.hpp"
#include "history/history.hpp"
#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! The warning beside a gain that a single search has found.
inline constexpr const char* one_seed =
    "one seed: ± is half of a 95 % interval of the light's noise, without the "
    "differences between searches (replicates = 3)";

//! The largest number of cases that each get a line on a terminal.
inline constexpr std::size_t lines_on_screen = 20;

//! Returns the slot in /final of the best finalist other than the baseline, or
//! 0 if only the baseline, in slot 0, has been evaluated.
std::size_t best_finalist(const History& history,
                          const std::vector<Row>& finalists);

//! Returns the key that ended a search. A history has room for as many rows as
//! stop.generations of the usual size have.
inline std::string in_words(const std::string& reason) {
    return "stop." + (reason == "room" ? "generations" : reason);
}

//! The result of a case, as in its history.
struct CaseResult {
    bool is_study = false;  //!< whether a sensitivity study, without a best
    int replicates = 1;     //!< evolutions of each case of the campaign
    std::optional<std::string> reason;  //!< reason for the end
    double complete = 0, generations = 0;
    double evaluations = 0, failures = 0;
    //! Plants of complete generations, and those that the history has room for.
    double plants = 0, most_plants = 0;
    double wall_time = 0;  //!< wall time of all sessions [s]
    std::string objective, unit;
    //! The best objective of the final evaluation, or of the last generation.
    std::optional<Estimate> best;
    std::optional<Estimate> hypervolume;
    bool is_evaluated_again = false;
    double violation = 0;  //!< violation of the best
    std::string gain;      //!< gain over the baseline; "" if unknown
    std::string doubt;     //!< doubt about the leaf area of the best
    //! Genes of the best plant at a bound, and the count of its traits, if it
    //! is evaluated again.
    std::vector<GeneAtBound> at_bounds{};
    BoundCount bounds{};
    std::size_t finalists = 0, failed_finalists = 0;
    std::string failure;  //!< first reason of failed finalists
    //! Keys of its campaign that this version does not have, see Spec.
    std::set<std::string> passed_over{};
};

CaseResult result_of(const History& history);

//! Returns a result as one line without line break.
//! @param state state of the case, such as "finished"
std::string to_text(const CaseResult& result, const std::string& path,
                    const std::string& state);

//! Returns a result as one short line without line break, for a list.
std::string in_short(const CaseResult& result, const std::string& name);

//! Returns a line about the most light that is left to gain, if the objective
//! is plain absorption in an endless stand, which has a ceiling; else "".
std::string left_to_gain(const History& history, const Campaign& campaign);

}  // namespace ideotype
