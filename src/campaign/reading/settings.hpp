// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "campaign/problems.hpp"

namespace ideotype {

//! Replaces values of a file by values from the command line, each given as
//! "table.key=value". A value is read as TOML or, if it is not valid TOML, as
//! text. Problems of a value are reported at "--set table.key=value".
void apply_settings(const std::vector<std::string>& settings,
                    toml::table& campaign, const Problems& problems);

}  // namespace ideotype
