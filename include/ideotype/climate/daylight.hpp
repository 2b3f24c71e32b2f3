// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "ideotype/climate/light_series.hpp"

namespace ideotype {

//! When the sun is up on a date, by the local clock and without refraction.
//! The day is the one around the noon that is nearest to 12:00.
struct Daylight {
    double noon = 12;               //!< when the sun is highest [h]
    double elevation = 0;           //!< of the sun then [deg]
    std::optional<double> sunrise;  //!< [h]; none if it is up, or down, all day
    std::optional<double> sunset;   //!< [h]; none if it is up, or down, all day
};

Daylight daylight(const Site& site, const Date& date);

//! How far the local clock is ahead of the mean sun's [h], from -12 to 12:
//! but for the equation of time, noon comes so much later than 12:00.
double clock_ahead(const Site& site);

//! The part of the light of clear days that comes before the start and after
//! the end of a span, from 0 to 1; 0 if there is no light.
double share_left_out(const Site& site, const DaySpan& span);

}  // namespace ideotype
