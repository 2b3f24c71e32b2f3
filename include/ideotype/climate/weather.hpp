// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

//! The first and the last day to be used from a file.
struct Period {
    Date from;
    Date to;
};

//! The moment of a time step to which the time stamp of a row refers.
enum class Stamp { beginning, middle, end };

//! The order of year, month and day in dates: 2011-07-21, 07/21/2011 or
//! 21/07/2011.
enum class DateOrder { year_month_day, month_day_year, day_month_year };

//! A column of a table, identified by the name in its header.
struct Column {
    std::string name;
    std::string unit;
};

//! The columns of a CSV file by their meaning. Light is given in W/m2 of solar
//! radiation, as energy per time step in Wh/m2, kWh/m2, kJ/m2 or MJ/m2, or in
//! umol/m2/s of photons from 400 to 700 nm. Global light is required, or both
//! beam and diffuse light.
struct ColumnMap {
    //! The columns of time. One: date and time as in ISO 8601, with or without
    //! the offset from UTC. Two: date, time. Four or five: year, month, day,
    //! hour, minute. None: the columns written by `ideotype weather`, with
    //! stamps at the middle of steps.
    std::vector<std::string> time{};
    DateOrder date_order = DateOrder::year_month_day;
    //! Offset of the clock from UTC [h] if stamps do not contain it; by default
    //! that of the site.
    std::optional<double> utc_offset{};
    std::optional<Stamp> stamp{};  //!< the end by default
    //! A number that marks a missing value, in addition to -99, -999, -9900,
    //! -9999, 9999, 99999, NaN, NA, null and an empty entry.
    std::optional<double> missing{};

    std::optional<Column> global{};  //!< light on a horizontal plane
    std::optional<Column>
        beam_normal{};                //!< light on a plane that faces the sun
    std::optional<Column> diffuse{};  //!< light on a horizontal plane
    std::optional<Column>
        diffuse_fraction{};  //!< fraction of global light; in 1 or %
    //! Photons from 400 to 700 nm on a horizontal plane, used only for
    //! comparison with the global light.
    std::optional<Column> ppfd{};
    std::optional<Column> temperature{};  //!< in C, K or F
    std::optional<Column> humidity{};     //!< relative humidity; in 1 or %
    std::optional<Column> wind{};         //!< in m/s, km/h, mph or kn
    std::optional<Column> pressure{};     //!< in kPa, hPa, mbar or Pa
    //! Longwave radiation of the sky on a level plane, in a unit of light.
    std::optional<Column> longwave{};
    std::optional<Column> rain{};  //!< in mm or in of a step, or in mm/h
};

//! The weather that is to be read from a CSV file.
struct WeatherRequest {
    std::string file;
    Site site;
    std::optional<Period> period{};  //!< the whole file by default
    ColumnMap columns{};
    double par_fraction = 0.45;  //!< PAR over all solar radiation
};

//! The weather of a period, nights included, without gaps, and warnings about
//! its file. One warning covers all findings of one kind, with their number and
//! the location of the first.
struct Weather {
    //! The light, with hour and sun at the middle of each step. The offset from
    //! UTC is that of the clock used for dates.
    LightSeries series;
    std::vector<Problem> warnings;
};

//! The description of a weather file that a campaign needs.
struct WeatherDescription {
    //! Columns of the file; without `time`, the columns written by `ideotype
    //! weather`.
    ColumnMap columns;
    Period period;  //!< the first and the last whole day
};

//! Recognises the columns of a weather file by names and units such as "Date",
//! "Time", "Solar rad (W/m2)" and "temp_c", and determines the order of dates
//! and the period. The units are those that parse_weather() accepts. Columns of
//! light or weather without a unit are omitted.
//! @param site location; its clock applies where stamps have no offset
//! @throws InputError if no columns of time and light are recognised.
WeatherDescription describe_weather(const std::string& text,
                                    const std::string& file, const Site& site);

//! Parses a weather file for a site; the name of the file is for messages.
//! Dates and hours follow the file's clock. If that clock differs by more than
//! 3 hours from mean solar time at the site, as in files in UTC, they follow
//! the site's clock. Beam and diffuse light on the ground are:
//!
//! - diffuse light as given, or from the given fraction; the rest of global
//!   light is beam. Without global light, the beam is the given beam times cos
//!   z
//! - if neither is given, the diffuse fraction follows from the clearness index
//!   (Erbs et al. 1982): see diffuse_fraction()
//! - with the sun below the horizon all light is diffuse
//! - a beam above the extraterrestrial one is capped, and the rest of global
//!   light counts as diffuse
//!
//! PAR is par_fraction of solar radiation; near infrared is the rest. If the
//! global light, or else the beam, is given in photons, PAR is computed from
//! photons and solar radiation from PAR: see par_share(). The diffuse fraction
//! of near infrared equals that of PAR. Light that is slightly below 0, or
//! missing while the sun is down, is set to 0. Rain counts by date, so that one
//! row may hold that of a day; where it is missing, there is none. Other
//! missing values are interpolated over up to 6 hours. If the file omits 29
//! February, so does the result.
//!
//! @throws InputError for unreadable or implausible input: unknown columns and
//! units, light that is missing by day, negative or above the extraterrestrial
//! light, wrong order, duplicates, gaps, days that are not in the file, and
//! light that does not follow the sun of the site.
Weather parse_weather(const std::string& text, const WeatherRequest& request);

//! A weather file with a table that is read once for several periods. All of
//! its rows must be readable and in order.
class WeatherFile {
  public:
    //! @param request its period only appears in messages
    //! @throws InputError if the text is not a table of weather.
    WeatherFile(std::string text, const WeatherRequest& request);

    //! Returns the weather of a period as parse_weather().
    //! @throws InputError as parse_weather().
    Weather parse(const std::optional<Period>& period) const;

  private:
    struct Contents;
    std::shared_ptr<const Contents> contents_;
};

}  // namespace ideotype
