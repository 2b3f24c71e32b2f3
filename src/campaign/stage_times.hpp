// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "campaign.hpp"

namespace ideotype {

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
