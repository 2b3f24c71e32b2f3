// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/climate/column_map.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

//! Which weather is wanted.
struct WeatherRequest {
    std::string file;
    Site site;
    std::optional<Period> period{};      //!< else all of the file
    std::optional<ColumnMap> columns{};  //!< of a CSV of no known format
    std::optional<Stamp> stamp{};        //!< else that of the format
    double par_fraction = 0.45;          //!< PAR over all solar radiation
};

//! The weather, and what is doubtful about its file. Like findings are one
//! warning, which counts them and has the place of the first.
struct WeatherReading {
    Weather weather;
    std::vector<Problem> warnings;
};

//! Reads a weather file for a site. Known by their beginnings are:
//!
//! - EPW (EnergyPlus, Auxiliary Programs): local standard time, hour ending
//! - TMY3 (Wilcox and Marion 2008, NREL/TP-581-43156): the same
//! - NSRDB, PSM 3 and 4: the stamp is the middle of the step; of hourly files
//!   of before May 2019, whose minutes are 0, the beginning
//! - NASA POWER, hourly: hour beginning, UTC or "LST", which is UTC shifted by
//!   whole hours of 15 degrees
//!
//! Typical years, whose months are of different years, have the dates of the
//! period. Dates and hours are those of the file's clock; where it is more
//! than 3 hours off the mean sun of the site, as in files in UTC, of the
//! site's.
//!
//! Beam and diffuse light on the ground:
//!
//! - diffuse as given, or by the given fraction; the rest of the global light
//!   is beam; without global light, the given beam times cos z
//! - else the diffuse fraction follows from the clearness index (Erbs et al.
//!   1982): see diffuse_fraction()
//! - with the sun below the horizon all light is diffuse
//! - a beam of more than the extraterrestrial one is capped; of global light
//!   the rest counts as diffuse
//!
//! Light slightly below 0, or not known while the sun is down, is 0.
//! Temperature and humidity are interpolated over up to 6 hours. A 29 February
//! that the file leaves out stays out.
//!
//! @throws InputError of what cannot be read or believed: unknown columns and
//! units, light that is missing by day, negative or beyond the sun's, wrong
//! order, duplicates, gaps, days that the file does not have, and light that
//! does not follow the sun of the site.
WeatherReading read_weather(const WeatherRequest& request);

//! The same of a text; the file is only named.
WeatherReading parse_weather(const std::string& text,
                             const WeatherRequest& request);

}  // namespace ideotype
