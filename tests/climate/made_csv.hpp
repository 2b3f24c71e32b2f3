// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "ideotype/climate/weather.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

//! A site where clocks show solar time, except for the equation of time.
inline const Site middle_west{"middle west", 42.0, -90.0, -6, 300};

//! Rows of a weather table that tests can modify. The light is half of the
//! extraterrestrial light at middle_west, hour by hour from a given date.
class MadeCsv {
  public:
    //! @param stamp the time stamp of each row, counted from the beginning of
    //! its hour [h]
    explicit MadeCsv(int days = 12, const Date& first = {2011, 7, 1},
                     double stamp = 0.5)
        : first_(first) {
        for (int hour = 0; hour < 24 * days; ++hour)
            rows.push_back(row(hour, stamp));
    }

    //! @param stamp the time stamp of the row, counted from the beginning of
    //! its hour [h]
    std::string row(int hour, double stamp) const {
        const double light = global(hour);
        return fmt::format("{},{:.6f},20.5,60", time(hour + stamp), light);
    }

    std::string time(double hour) const {
        Date date = first_;
        date.day += static_cast<int>(std::floor(hour / 24));
        const double left = hour - 24 * std::floor(hour / 24);
        return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", date.year,
                           date.month, date.day, static_cast<int>(left),
                           static_cast<int>(std::lround(left * 60)) % 60);
    }

    double global(int hour) const {
        const double zenith =
            sun_position(middle_west, first_, hour + 0.5).zenith;
        return 0.5 * extraterrestrial_normal(first_) *
               std::max(0.0, std::cos(zenith * degree));
    }

    std::string text() const {
        std::string lines = header;
        for (const std::string& row : rows) lines += "\n" + row;
        return lines + "\n";
    }

    //! Returns the line number of a row in the file; the first line is 1.
    static int line(std::size_t row) { return static_cast<int>(row) + 2; }

    std::string header = "time,ghi,t,rh";
    std::vector<std::string> rows;

  private:
    Date first_;
};

//! Makes a request that reads a MadeCsv.
inline WeatherRequest made_request() {
    ColumnMap columns;
    columns.time = {"time"};
    columns.stamp = Stamp::middle;
    columns.global = Column{"ghi", "W/m2"};
    columns.temperature = Column{"t", "C"};
    columns.humidity = Column{"rh", "%"};
    WeatherRequest request{"made.csv", middle_west};
    request.columns = columns;
    return request;
}

//! Returns the error message for a text, or "" if it is valid.
inline std::string parse_error(const std::string& text,
                               const WeatherRequest& request) {
    try {
        parse_weather(text, request);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace ideotype
