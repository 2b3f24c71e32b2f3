// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace ideotype {

//! Parses a duration such as "90", "90s", "1m", "2h", "1h30m" or "HH:MM:SS"
//! [s]; returns nothing for other texts.
std::optional<double> parse_duration(const std::string& text);

//! Formats the lead of a clock over UTC [h]: "UTC-5", "UTC+5:30" or "UTC".
std::string clock_name(double utc_offset);

//! Formats a local clock time [h], which may belong to the day before or after,
//! as "HH:MM".
std::string clock_time(double hour);

}  // namespace ideotype
