// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "weather_times.hpp"

namespace ideotype {

//! What a row tells, in our units; nothing where it is not known.
struct WeatherValues {
    std::optional<double> global;            //!< [W m-2]
    std::optional<double> beam_normal;       //!< [W m-2]
    std::optional<double> diffuse;           //!< [W m-2]
    std::optional<double> diffuse_fraction;  //!< of global, 0 to 1
    std::optional<double> temperature;       //!< [deg C]
    std::optional<double> humidity;          //!< 0 to 1

    //! Whether the light on the ground follows.
    bool lit() const { return global || (beam_normal && diffuse); }
};

//! The values of each of the rows.
//! @throws InputError of columns, units and numbers that cannot be read.
std::vector<WeatherValues> read_values(
    const std::vector<std::string_view>& lines, const Layout& layout,
    const RowTimes& times, const WeatherRequest& request);

}  // namespace ideotype
