// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "weather_table.hpp"

namespace ideotype {

//! Returns all solar radiation on the ground [W m-2], of each step.
//! @throws InputError if light is not known by day.
std::vector<Irradiance> light_of(const std::vector<WeatherStep>& series,
                                 Findings& findings);

//! Stops or warns if the light is hardly that of a site, whose clock is that
//! of the steps.
//! @throws InputError
void check_place(const std::vector<WeatherStep>& series,
                 const std::vector<Irradiance>& light, const Site& site,
                 Findings& findings);

}  // namespace ideotype
