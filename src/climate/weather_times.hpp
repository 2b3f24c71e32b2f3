// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "ideotype/climate/weather_reader.hpp"
#include "time_stamp.hpp"
#include "weather_layout.hpp"

namespace ideotype {

//! When the time step of a row is.
struct RowTime {
    int line = 0;
    ClockTime middle;
};

//! The rows of a period in order.
struct RowTimes {
    std::vector<RowTime> rows;
    double utc_offset = 0;  //!< of the clock [h]
    std::chrono::seconds step{3600};
    //! Of a period: its first and last midnight; else the first and last rows.
    ClockTime begin, end;
};

//! @throws InputError of stamps that cannot be read, of rows that are not in
//! order, and if the file does not have the period.
RowTimes read_times(const std::vector<std::string_view>& lines,
                    const Layout& layout, const WeatherRequest& request);

}  // namespace ideotype
