// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

//! Days of a file, both included.
struct Period {
    Date from;
    Date to;
};

//! The part of its time step that the stamp of a row names.
enum class Stamp { beginning, middle, end };

//! The order in dates: 2011-07-21, 07/21/2011 or 21/07/2011.
enum class DateOrder { year_month_day, month_day_year, day_month_year };

//! A column of a table, by the name in its header.
struct Column {
    std::string name;
    std::string unit;
};

//! The columns of a CSV file by their meaning.
//!
//! Units of light: W/m2 of all solar radiation, its energy in the time step as
//! Wh/m2, kWh/m2, kJ/m2 or MJ/m2, or umol/m2/s of photons from 400 to 700 nm.
//! There must be the global light, or the beam and the diffuse.
struct ColumnMap {
    //! One name: date and time, as in ISO 8601, with or without the offset
    //! from UTC. Two: the date and the time. Four or five: year, month, day,
    //! hour and minute. None: the file has the columns that `ideotype weather`
    //! writes, whose stamps are the middles of steps.
    std::vector<std::string> time{};
    DateOrder date_order = DateOrder::year_month_day;
    //! The offset of the clock [h], where stamps do not tell; else that of the
    //! site.
    std::optional<double> utc_offset{};
    std::optional<Stamp> stamp{};  //!< else the end
    //! A number that means "not known", beside -99, -999, -9900, -9999, 9999,
    //! 99999, NaN, NA, null and nothing at all.
    std::optional<double> missing{};

    std::optional<Column> global{};            //!< on a horizontal plane
    std::optional<Column> beam_normal{};       //!< on a plane facing the sun
    std::optional<Column> diffuse{};           //!< on a horizontal plane
    std::optional<Column> diffuse_fraction{};  //!< of the global light; 1 or %
    //! Photons from 400 to 700 nm on a horizontal plane, which are compared
    //! with the global light and otherwise of no account.
    std::optional<Column> ppfd{};
    std::optional<Column> temperature{};  //!< C, K or F
    std::optional<Column> humidity{};     //!< relative; 1 or %
    std::optional<Column> wind{};         //!< m/s, km/h, mph or kn
    std::optional<Column> pressure{};     //!< kPa, hPa, mbar or Pa
    //! Longwave radiation of the sky on a level plane, in units of light.
    std::optional<Column> longwave{};
};

//! The weather that is wanted of a CSV file.
struct WeatherRequest {
    std::string file;
    Site site;
    std::optional<Period> period{};  //!< else all of the file
    ColumnMap columns{};
    double par_fraction = 0.45;  //!< PAR over all solar radiation
};

//! The weather of a period, night included, without gaps, and what is doubtful
//! about its file. Like findings are one warning, which counts them and has the
//! place of the first.
struct Weather {
    //! Hours and suns are those of the middle of each step; its offset from UTC
    //! is that of the clock of dates.
    LightSeries series;
    std::vector<Problem> warnings;
};

//! Reads the text of a weather file for a site; the file is only named.
//!
//! Dates and hours are those of the file's clock; where it is more than 3 hours
//! off the mean sun of the site, as in files in UTC, of the site's. Beam and
//! diffuse light on the ground:
//!
//! - diffuse as given, or by the given fraction; the rest of the global light
//!   is beam; without global light, the given beam times cos z
//! - else the diffuse fraction follows from the clearness index (Erbs et al.
//!   1982): see diffuse_fraction()
//! - with the sun below the horizon all light is diffuse
//! - a beam of more than the extraterrestrial one is capped; of global light
//!   the rest counts as diffuse
//!
//! PAR is par_fraction of solar radiation; near infrared is the rest. Where the
//! global light, or else the beam, is told in photons, PAR follows from them
//! and solar radiation from PAR: see par_share(). Near infrared has the diffuse
//! fraction of PAR.
//!
//! Light slightly below 0, or not known while the sun is down, is 0.
//! All else is interpolated over up to 6 hours. A 29 February
//! that the file leaves out stays out.
//!
//! @throws InputError of what cannot be read or believed: unknown columns and
//! units, light that is missing by day, negative or beyond the sun's, wrong
//! order, duplicates, gaps, days that the file does not have, and light that
//! does not follow the sun of the site.
Weather parse_weather(const std::string& text, const WeatherRequest& request);

}  // namespace ideotype
