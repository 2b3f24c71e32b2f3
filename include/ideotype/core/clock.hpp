// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace ideotype {

//! Returns the seconds of "90", "90s", "1m", "2h", "1h30m" or "HH:MM:SS";
//! nothing if the text is none of these.
std::optional<double> parse_duration(const std::string& text);

//! Returns the name of a clock by its lead over UTC [h]: "UTC-5", "UTC+5:30" or
//! "UTC".
std::string clock_name(double utc_offset);

//! Returns a local clock time [h], which may be of the day before or after, as
//! "HH:MM".
std::string clock_time(double hour);

}  // namespace ideotype
