#pragma once

#include <optional>
#include <string>

namespace ideotype {

//! The seconds of "90", "90s", "1m", "2h", "1h30m" or "HH:MM:SS"; nothing if
//! the text is none of these, or no time at all.
std::optional<double> parse_wall_time(const std::string& text);

}  // namespace ideotype
