// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace ideotype {

//! The seconds of "90", "90s", "1m", "2h", "1h30m" or "HH:MM:SS"; nothing if
//! the text is none of these.
std::optional<double> parse_duration(const std::string& text);

//! A local clock time [h] as "HH:MM"; it may be of the day before or after.
std::string clock_time(double hour);

}  // namespace ideotype
