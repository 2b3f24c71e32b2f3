// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <compare>
#include <string>

namespace ideotype {

//! A place on Earth and its clear-sky air.
struct Site {
    std::string name;
    double latitude = 0;         //!< [deg], north positive
    double longitude = 0;        //!< [deg], east positive
    double utc_offset = 0;       //!< of the local clock [h]
    double elevation = 0;        //!< above sea level [m]
    double linke_turbidity = 3;  //!< [-], 2 very clear ... 7 hazy
    std::string weather{};       //!< file of it, if there is one
};

//! A day of the Gregorian calendar.
struct Date {
    int year = 2025;
    int month = 1;
    int day = 1;

    auto operator<=>(const Date&) const = default;
};

//! The day of a date.
inline std::chrono::sys_days day_of(const Date& date) {
    return std::chrono::year{date.year} /
           std::chrono::month{static_cast<unsigned>(date.month)} /
           std::chrono::day{static_cast<unsigned>(date.day)};
}

std::string to_string(const Date& date);  //!< such as 2025-08-07

}  // namespace ideotype
