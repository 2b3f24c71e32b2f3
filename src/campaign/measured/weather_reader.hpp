// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"
#include "campaign/reading/reader.hpp"

namespace ideotype {

//! Reads the weather files of a campaign, for each site in each climate, but
//! for weather that it has already; resolved campaigns have all. What is wrong
//! with a file is reported with its line.
//! @param file of the campaign, which names of weather files are relative to
void read_weathers(const std::string& file, PlantSource source, Draft& draft,
                   const Problems& problems);

}  // namespace ideotype
