// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "spec/problems.hpp"
#include "spec/reader.hpp"

namespace ideotype {

//! Reads the weather of each site in each climate from files. Does nothing if
//! the campaign contains the weather, as resolved campaigns do. Problems are
//! reported with file and line.
//! @param file path of the campaign, to which paths of weather files are
//! relative
void read_weathers(const std::string& file, TextSource source, Spec& spec,
                   const Problems& problems);

}  // namespace ideotype
