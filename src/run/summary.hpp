// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/campaign.hpp"
#include "history/history.hpp"
#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! The warning beside a gain that one search alone has found.
inline constexpr const char* one_seed =
    "one seed: the interval holds the noise of the light, not that of the "
    "search";

//! Daily energy per ground area in the three units of the field:
//! "x MJ m-2 day-1 = y mol m-2 day-1 = z MWh acre-1 day-1".
std::string format_daily(Estimate mj_per_m2);

//! Slot in /final of the best finalist other than the baseline in slot 0, or
//! 0 if nothing but the baseline has been evaluated.
std::size_t best_finalist(const std::vector<Row>& finalists, Sense sense);

//! Counts the finalists that could not be evaluated.
std::size_t failed_finalists(const std::vector<Row>& finalists);

//! Tells how many finalists could not be evaluated and why, or "".
std::string failures_of(const std::vector<Row>& finalists);

//! Best plant against the baseline after a finished evolution, both evaluated
//! again under the same fresh random numbers.
std::string final_summary(const History& history, const Campaign& campaign);

//! Tells the result of a case in one line without its end.
std::string final_line(const History& history);

}  // namespace ideotype
