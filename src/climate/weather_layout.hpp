// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ideotype/climate/weather_reader.hpp"
#include "ideotype/core/csv.hpp"

namespace ideotype {

//! Where a file says that it was measured.
struct Station {
    double latitude = 0;   //!< [deg]
    double longitude = 0;  //!< [deg]
};

//! How a format writes its hours.
enum class HourStyle {
    plain,       //!< 0 to 24, minutes after it
    energy_plus  //!< 1 to 24, the hour that ends with the minutes
};

//! What the head of a file tells about its rows.
struct Layout {
    ColumnMap columns;
    std::vector<CsvField> header;  //!< names of the columns
    std::size_t header_line = 0;  //!< of the names, from 1; 0 if there are none
    std::size_t first_row = 0;    //!< index of a line
    HourStyle hours = HourStyle::plain;
    std::optional<Station> station;
    //! Months may be of different years, which mean nothing.
    bool may_be_typical = false;
};

//! @throws InputError if the file is of no known format and no columns are
//! given, or if its head cannot be read.
Layout layout_of(const std::vector<std::string_view>& lines,
                 const WeatherRequest& request);

}  // namespace ideotype
