// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ideotype {

//! Which part of its time step the stamp of a row names.
enum class Stamp { beginning, middle, end };

//! How dates are written: 2011-07-21, 07/21/2011 or 21/07/2011.
enum class DateOrder { year_month_day, month_day_year, day_month_year };

//! A column of a table, by the name in its header.
struct Column {
    std::string name;
    std::string unit;
    //! A number that means "not known", beside -99, -999, -9900, -9999, 9999,
    //! 99999, NaN, NA, null and nothing at all.
    std::optional<double> missing{};
};

//! Which columns of a CSV file tell what.
//!
//! Units of light: W/m2 of all solar radiation, its energy in the time step as
//! Wh/m2, kWh/m2, kJ/m2 or MJ/m2, or umol/m2/s of photons from 400 to 700 nm.
//! There must be the global light, or the beam and the diffuse.
struct ColumnMap {
    //! One name: date and time, as in ISO 8601, with or without the offset
    //! from UTC. Two: the date and the time. Four or five: year, month, day,
    //! hour and minute.
    std::vector<std::string> time;
    DateOrder date_order = DateOrder::year_month_day;
    //! Of the clock [h], where stamps do not tell; else that of the site.
    std::optional<double> utc_offset;
    Stamp stamp = Stamp::end;

    std::optional<Column> global;            //!< on a horizontal plane
    std::optional<Column> beam_normal;       //!< on a plane that faces the sun
    std::optional<Column> diffuse;           //!< on a horizontal plane
    std::optional<Column> diffuse_fraction;  //!< of the global light; 1 or %
    std::optional<Column> temperature;       //!< C, K or F
    std::optional<Column> humidity;          //!< relative; 1 or %
};

}  // namespace ideotype
