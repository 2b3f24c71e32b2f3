// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace ideotype {

//! Guesses the TOML value that a text stands for: 05:00:00 for "5:00",
//! 2025-07-15 for "15.07.2025", 0.8 for ".8". Returns nothing without a guess.
std::optional<std::string> meant_time(const std::string& text);
std::optional<std::string> meant_date(const std::string& text);
std::optional<std::string> meant_number(const std::string& text);

//! Returns whether a text is the end of a day, "24:00".
bool is_midnight(const std::string& text);

//! Returns advice on how to correct a line that is not valid TOML.
std::string line_advice(const std::string& line);

}  // namespace ideotype
