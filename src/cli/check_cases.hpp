// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/campaign.hpp"

namespace ideotype {

//! Prints index, name and seed of each case.
void list_cases(const Campaign& campaign);

//! Prints index and evaluations done of each case that is not finished in a
//! folder, with a tab between them.
//! @throws Error (refused) if a history is of another campaign.
void list_left(const Campaign& campaign, const std::string& out);

}  // namespace ideotype
