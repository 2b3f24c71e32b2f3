// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ideotype/climate/sun.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/csv.hpp"
#include "time_stamp.hpp"
#include "weather_findings.hpp"

namespace ideotype {

//! The values of a row in our units; nothing where one is not known.
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

//! A time step, which has a row of the file or lies between rows.
struct WeatherStep {
    int line = 0;  //!< of its row, or of the row before it
    ClockTime middle;
    WeatherValues values{};
    SunPosition sun{};   //!< in the middle
    double highest = 0;  //!< elevation of the sun, begin, middle or end [deg]
};

//! The rows of a period in order.
struct WeatherTable {
    ColumnMap columns;
    std::vector<CsvField> header;  //!< names of the columns
    std::size_t header_line = 0;   //!< from 1
    std::vector<WeatherStep> rows{};
    double utc_offset = 0;  //!< of the clock [h]
    std::chrono::seconds step{3600};
    //! The ends of a period: its first and last midnight; else the first and
    //! last rows.
    ClockTime begin{}, end{};

    //! The index of the column of this name; adds a problem if there is not
    //! one.
    std::optional<std::size_t> index_of(const std::string& name,
                                        Findings& findings) const;
};

//! Reads head and rows of a period, without values.
//! @throws InputError if the file is no such table, of stamps that cannot be
//! read, of rows that are not in order, and if it does not have the period.
WeatherTable read_table(const std::vector<std::string_view>& lines,
                        const WeatherRequest& request, Findings& findings);

//! Reads the values of each of the rows.
//! @throws InputError of columns, units and numbers that cannot be read.
void read_values(WeatherTable& table,
                 const std::vector<std::string_view>& lines,
                 double par_fraction, Findings& findings);

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

//! Returns the entry of a row; an empty one if the row is too short.
inline CsvField entry(const std::vector<CsvField>& fields, std::size_t index) {
    return index < fields.size() ? fields[index]
                                 : CsvField{{}, fields.back().column};
}

}  // namespace ideotype
