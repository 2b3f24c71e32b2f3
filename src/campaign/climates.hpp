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
    std::string file;  //!< as written; "" if each site has one of its own
    Period period;
    std::string stamp;  //!< "": that of the format
    ColumnMap columns;
    std::optional<double> wind_height;  //!< above the ground [m]
    std::optional<double> co2;          //!< CO2 of the air [umol mol-1]
    //! The day on which plants emerge that then grow; of year 0: they stand as
    //! they are.
    Date emergence{0, 1, 1};

    bool grows() const { return emergence.year > 0; }
};

//! The weather of a site in a climate, as it was read.
struct SiteWeather {
    std::string site, climate;  //!< names
    std::string sha256;         //!< SHA-256 of the file
    double utc_offset = 0;      //!< offset from UTC of dates and hours [h]
    std::vector<Date> dates;
    std::vector<double> hours;  //!< hours of each day: the middles of steps [h]
    //! Light on a horizontal plane, date by date and hour by hour [W m-2];
    //! nothing in wavebands that the campaign does not follow.
    ByBand<std::vector<double>> beam, diffuse;
    //! If they are known, in that order: temperature [deg C], relative humidity
    //! (0 to 1), wind [m s-1], pressure [kPa] and longwave radiation of the sky
    //! [W m-2].
    std::vector<double> temperature, humidity, wind, pressure, longwave;
};

}  // namespace ideotype
