// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "ideotype/core/error.hpp"
#include "spec/problems.hpp"

namespace ideotype {

//! The prefix that marks the command line, rather than a file, as the source of
//! a value.
inline constexpr std::string_view command_line_mark = "--set ";

//! Returns the position of a node or key in a file or on the command line.
Location location(const toml::source_region& source, const std::string& file);

//! Returns the kind of a node in words: "an integer", "a table", ...
std::string kind(const toml::node& node);

//! Returns a value as TOML on one line.
std::string toml_of(const toml::node& node);

//! Returns whether a text may be part of the name of a file on any system.
bool is_name(const std::string& text);

//! Makes a valid name from any text: invalid characters become _.
std::string make_name(const std::string& text);

//! Parses TOML text, or reports the first syntax error.
std::optional<toml::table> parse_toml(const std::string& text,
                                      const std::string& file,
                                      const Problems& problems);

//! Replaces values of a file by settings from the command line, such as
//! "table.key=value". A value is read as TOML or, if it is not valid TOML, as
//! text. A table in braces replaces the whole table. Settings are applied in
//! order. Problems are reported at "--set table.key=value".
void apply_settings(const std::vector<std::string>& settings,
                    toml::table& campaign, const Problems& problems);

}  // namespace ideotype
