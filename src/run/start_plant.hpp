// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/campaign.hpp"

namespace ideotype {

//! The setting "search.start=[...]" for a plant: of a crop file what traits
//! set, of a history the genes of its best finalist, by name. What is not known
//! of it is as in the baseline.
//! @throws Error if the file cannot be read or has no finalist.
//! @throws InputError with all problems of a crop file.
std::string start_setting(const Campaign& campaign, const std::string& path);

}  // namespace ideotype
