// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "campaign.hpp"

namespace ideotype {

//! Adds its stages to a case whose plants grow: from the first leaf to
//! maturity, or to the end of the period, where straight lines between them
//! follow best what leaves intercept.
void add_stages(const Campaign& campaign, Case& one);

//! Returns the stage of plants on a date, at its noon, or at a thermal time of
//! the campaign's crop [deg C d]; it stands for the hours of that day.
//! @param one a case without scenarios, or one of them
//! @throws Error (usage) if they do not, or if it is not in their season.
Stage stage_on(const Campaign& campaign, const Case& one,
               const std::variant<Date, double>& when);

//! Leaves the hours of a stage of all of a period, each with the part of its
//! time that the stage stands for.
LightSeries at_stage(const Campaign& campaign, const Case& chosen,
                     LightSeries series);

//! Returns the growth of a component, that of the campaign's crop first; null
//! if it does not grow.
const Growth* growth_of(const Campaign& campaign, std::size_t component);

}  // namespace ideotype
