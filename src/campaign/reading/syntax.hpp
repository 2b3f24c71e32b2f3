// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <toml++/toml.h>

#include "campaign/problems.hpp"

namespace ideotype {

//! Parses TOML text, or reports the first place of wrong syntax.
std::optional<toml::table> parse_toml(const std::string& text,
                                      const std::string& file,
                                      const Problems& problems);

}  // namespace ideotype
