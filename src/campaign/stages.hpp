// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "campaign.hpp"

namespace ideotype {

//! Adds stages to a case whose plants grow, from the first leaf to maturity or
//! to the end of the period. They are at the ages from which straight lines
//! follow best how much light leaves intercept.
void add_stages(const Campaign& campaign, Case& one);

//! Returns the stage of plants at noon of a date, or at a thermal time of the
//! campaign's crop [deg C d]. It stands for the hours of that day.
//! @param one a case without scenarios, or a single scenario of a case
//! @throws Error (usage) if plants do not grow, or if the time is not in their
//! season.
Stage stage_on(const Campaign& campaign, const Case& one,
               const std::variant<Date, double>& when);

//! Returns the hours of a period for which a stage stands, each with the part
//! of its time that belongs to the stage.
LightSeries at_stage(const Campaign& campaign, const Case& chosen,
                     LightSeries series);

//! Returns the growth of a component, that of the campaign's crop first; null
//! if it does not grow.
const Growth* growth_of(const Campaign& campaign, std::size_t component);

}  // namespace ideotype
