// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/weather.hpp"

namespace ideotype {

//! The weather of a period from a file.
struct Climate {
    std::string file;  //!< path as written; "": each site has its own
    Period period;
    std::string stamp;  //!< time stamp; "": as in the format
    ColumnMap columns;
    std::optional<double> wind_height;  //!< height above the ground [m]
    std::optional<double> co2;          //!< CO2 of the air [umol mol-1]
    //! The day on which growing plants emerge; year 0: plants do not grow.
    Date emergence{0, 1, 1};

    bool grows() const { return emergence.year > 0; }
};

//! The weather of a site in a climate, as it was read.
struct SiteWeather {
    std::string site, climate;  //!< names of the site and the climate
    std::string sha256;         //!< SHA-256 of the weather file
    double utc_offset = 0;      //!< time of dates and hours, from UTC [h]
    std::vector<Date> dates;
    std::vector<double> hours;  //!< middle of each step of a day [h]
    //! Light on a horizontal plane, date by date and hour by hour [W m-2];
    //! empty in wavebands that the campaign does not follow.
    ByBand<std::vector<double>> beam, diffuse;
    //! Air temperature [deg C], relative humidity (0 to 1), wind [m s-1],
    //! pressure [kPa] and longwave radiation of the sky [W m-2]; may be empty.
    std::vector<double> temperature, humidity, wind, pressure, longwave;
};

}  // namespace ideotype
