// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"
#include "campaign/reading/reader.hpp"

namespace ideotype {

//! Reads the weather files of a campaign, for each site in each climate, unless
//! the draft has the weather already; resolved campaigns have all. Problems of
//! a file are reported with their line.
//! @param file path of the campaign, from which weather files are found
void read_weathers(const std::string& file, PlantSource source, Draft& draft,
                   const Problems& problems);

}  // namespace ideotype
