// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "campaign.hpp"

namespace ideotype {

//! Adds stages to a case whose plants grow, from the first leaf to maturity or
//! to the end of the period. The ages of stages are chosen so that straight
//! lines between them follow best how much light leaves intercept.
void add_stages(const Campaign& campaign, Case& one);

//! Returns the stage of plants at noon of a date, or at a thermal time of the
//! campaign's crop [deg C d]. The stage stands for the hours of the day.
//! @param one a case without scenarios, or a single scenario of a case
//! @throws Error of wrong usage if plants do not grow or it is not their
//! season.
Stage stage_on(const Campaign& campaign, const Case& one,
               const std::variant<Date, double>& when);

//! Returns the hours of a period for which a stage stands, each with the share
//! of its time that belongs to the stage.
LightSeries at_stage(const Campaign& campaign, const Case& chosen,
                     LightSeries series);

//! Returns the growth of a component, number 0 being the campaign's crop; null
//! if the component does not grow.
const Growth* growth_of(const Campaign& campaign, std::size_t component);

//! The thermal time of a stage [deg C d], and roughly the part of light that
//! green leaves of the baseline then intercept.
struct StageTime {
    double at, interception;
};

//! Returns the thermal times of a campaign's stages up to some time. A single
//! stage is in the middle of the time with the most leaves.
std::vector<StageTime> stage_times(const Campaign& campaign,
                                   double ground_per_plant, double last);

}  // namespace ideotype
