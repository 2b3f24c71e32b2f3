// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "ideotype/climate/weather.hpp"
#include "ideotype/core/csv.hpp"

namespace ideotype {

//! An instant by some clock.
using ClockTime = std::chrono::local_seconds;

//! A time as it stands in a file.
struct WrittenTime {
    ClockTime time;
    std::optional<double> utc_offset;  //!< [h]
};

//! The first instant of a date.
ClockTime midnight(const Date& date);

//! The date at an instant.
Date date_at(ClockTime time);

//! Hours since midnight.
double hour_at(ClockTime time);

//! The instant so many hours later, to the nearest second.
ClockTime later(ClockTime time, double hours);

//! Reads the columns of a time: one, a date, T or a blank, a clock time, and
//! perhaps Z or an offset like -06:00; two, date and clock time; four or five,
//! year, month, day, hour and minute. Dates are 2011-07-21, or in another
//! order, also with / or . or nothing between, clock times 13:30, 13:30:00,
//! 1330 or 24:00.
std::optional<WrittenTime> parse_time(const std::vector<CsvField>& parts,
                                      DateOrder order);

}  // namespace ideotype
