// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "campaign/problems.hpp"

namespace ideotype {

//! Puts values from the command line, each as "table.key=value", in the place
//! of those of a file. A value is read as TOML and, where it is none, as text.
//! What is wrong with one is reported at "--set table.key=value".
void apply_settings(const std::vector<std::string>& settings,
                    toml::table& campaign, const Problems& problems);

}  // namespace ideotype
