// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "ideotype/climate/weather.hpp"

namespace ideotype {

//! An instant by some clock.
using ClockTime = std::chrono::local_seconds;

//! A time as it stands in a file.
struct WrittenTime {
    ClockTime time;
    std::optional<double> utc_offset;  //!< [h]
};

//! The first instant of a date; nothing if there is no such date.
std::optional<ClockTime> midnight(int year, int month, int day);
ClockTime midnight(const Date& date);

//! The date at an instant.
Date date_at(ClockTime time);

//! Hours since midnight.
double hour_at(ClockTime time);

//! The instant so many hours later, to the nearest second.
ClockTime later(ClockTime time, double hours);

//! 2011-07-21, or in another order; also with / or . or nothing between.
std::optional<ClockTime> parse_date(std::string_view text, DateOrder order);

//! The hours of 13:30, 13:30:00, 1330 or 24:00.
std::optional<double> parse_clock(std::string_view text);

//! A date, T or a blank, a clock time, and perhaps Z or an offset like -06:00.
std::optional<WrittenTime> parse_time(std::string_view text, DateOrder order);

}  // namespace ideotype
