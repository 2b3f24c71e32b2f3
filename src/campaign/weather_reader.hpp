// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "spec/problems.hpp"
#include "spec/reader.hpp"

namespace ideotype {

//! Reads the weather files of a campaign, for each site in each climate, unless
//! the campaign has the weather already; resolved campaigns have all. Problems
//! of a file are reported with their line.
//! @param file path of the campaign, from which weather files are found
void read_weathers(const std::string& file, TextSource source, Spec& spec,
                   const Problems& problems);

}  // namespace ideotype
