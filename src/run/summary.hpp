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

//! The warning that is printed with the gain of a single search.
inline constexpr const char* one_seed =
    "one seed: ± is half of a 95 % confidence interval of light noise only; "
    "replicates = 3 adds the differences between searches";

//! The largest number of cases that are listed one by one on a terminal.
inline constexpr std::size_t lines_on_screen = 20;

//! Returns the slot in /final of the best finalist except the baseline. Returns
//! 0, the slot of the baseline, if no other was evaluated.
std::size_t best_finalist(const History& history,
                          const std::vector<Row>& finalists);

//! Returns the key of the stop rule that ended a search. For "room" this is
//! stop.generations, since the history has room for that many generations of
//! the usual size.
inline std::string in_words(const std::string& reason) {
    return "stop." + (reason == "room" ? "generations" : reason);
}

//! The result of a case, which is read from its history.
struct CaseResult {
    bool is_study =
        false;  //!< whether it is a sensitivity study, which has no best plant
    int replicates = 1;                 //!< searches per case in the campaign
    std::optional<std::string> reason;  //!< reason why the case ended
    double complete = 0, generations = 0;
    double evaluations = 0, failures = 0;
    //! Plants of complete generations, and the largest number for which the
    //! history has room.
    double plants = 0, most_plants = 0;
    double wall_time = 0;  //!< wall time of all sessions [s]
    std::string objective, unit;
    //! Best objective, from the final evaluation or from the last generation.
    std::optional<Estimate> best;
    std::optional<Estimate> hypervolume;
    bool is_evaluated_again = false;
    double violation = 0;  //!< constraint violation of the best plant
    std::string gain;      //!< gain over the baseline; "" if unknown
    std::string doubt;     //!< warning about the best plant's leaf area
    //! Genes of the re-evaluated best plant that are at a bound, and how often
    //! its traits are.
    std::vector<GeneAtBound> at_bounds{};
    BoundCount bounds{};
    std::size_t finalists = 0, failed_finalists = 0;
    std::string failure;  //!< reason of the first failed finalist
    //! Keys of the campaign that this version does not know, see Spec.
    std::set<std::string> passed_over{};
};

CaseResult result_of(const History& history);

//! Formats a result as one line.
//! @param state state of the case, such as "finished"
std::string to_text(const CaseResult& result, const std::string& path,
                    const std::string& state);

//! Formats a result as one short line of a list.
std::string in_short(const CaseResult& result, const std::string& name);

//! Returns a line about the largest further gain that is possible, if the
//! objective is light absorption in an endless stand; else "". The limit is the
//! light that other organs and the soil absorb.
std::string left_to_gain(const History& history, const Campaign& campaign);

}  // namespace ideotype
