// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "weather_doubts.hpp"
#include "weather_series.hpp"

namespace ideotype {

//! All solar radiation on the ground [W m-2], of each step.
//! @throws InputError if light is not known by day.
std::vector<Irradiance> light_of(const std::vector<SeriesStep>& series,
                                 const WeatherRequest& request, Doubts& doubts);

}  // namespace ideotype
