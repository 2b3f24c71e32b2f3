// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/climate/sun.hpp"
#include "weather_doubts.hpp"
#include "weather_times.hpp"
#include "weather_values.hpp"

namespace ideotype {

//! A time step of a series without gaps.
struct SeriesStep {
    int line = 0;  //!< of a step that no row is of, that of the row before it
    ClockTime middle;
    WeatherValues values;
    SunPosition sun;  //!< in the middle
    double highest =
        0;  //!< elevation of the sun, at begin, middle or end [deg]
};

//! Every time step of the period, whether the file has a row of it or not.
//! Temperature and humidity are interpolated where they are not known.
//! @throws InputError if rows lie between the steps, or if more than 6 hours
//! of temperature or humidity are not known.
std::vector<SeriesStep> complete_series(
    const RowTimes& times, const std::vector<WeatherValues>& values,
    const WeatherRequest& request, Doubts& doubts);

}  // namespace ideotype
