#pragma once

#include <optional>
#include <string>

#include <toml++/toml.h>

#include "report.hpp"

namespace ideotype {

//! Parses TOML text. Lines `key = value` with wrong syntax are reported, then
//! muted and skipped so that the rest can still be checked; nothing is
//! returned if the rest can't be told from the text.
std::optional<toml::table> parse_toml(std::string text, const std::string& file,
                                      Report& report);

}  // namespace ideotype
