// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/campaign.hpp"
#include "log.hpp"

namespace ideotype {

//! Tells what may be wrong with a campaign.
void print_warnings(const Campaign& campaign, const Log& log);

//! A line for each site and day of a campaign: when the sun is up by the local
//! clock, what the day leaves out, and how far the clock is ahead of the sun.
std::string sky_table(const Campaign& campaign);

}  // namespace ideotype
