// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! The days that count, and the part of each.
struct DaySpan {
    std::vector<Date> dates;   //!< in order
    double start = 7;          //!< local clock [h]
    double end = 20;           //!< local clock [h], after start
    double step_minutes = 30;  //!< divides end - start
};

//! One instant that stands for the time around it.
struct TimeStep {
    double hour = 0;     //!< site's clock, of the date or around it [h]
    double seconds = 0;  //!< the time that it stands for [s]
    SunPosition sun;
    Irradiance par;  //!< photosynthetically active, horizontal [W m-2]
    Date date{};     //!< on the clock of the weather file, if there is one
    std::optional<double> temperature{};  //!< temperature of the air [deg C]
    std::optional<double> humidity{};     //!< relative, 0 to 1
    //! The solar radiation beyond PAR, all of which counts as near infrared,
    //! horizontal [W m-2].
    Irradiance nir{};
    std::optional<double> wind{};      //!< at LightSeries::wind_height [m s-1]
    std::optional<double> pressure{};  //!< pressure of the air [kPa]
    //! Longwave radiation of the sky, horizontal [W m-2].
    std::optional<double> longwave{};
    bool is_late = false;  //!< after the silking of plants that grow

    bool is_lit() const { return par.beam + par.diffuse > 0; }
};

//! The light of one or more days as weighted instants, in order. Those
//! without light may be left out.
struct LightSeries {
    std::vector<TimeStep> steps;
    int days = 1;
    double utc_offset = 0;    //!< offset from UTC of the clock of hours [h]
    double wind_height = 10;  //!< above the ground [m]
    double co2 = 400;         //!< CO2 of the air [umol mol-1]
    //! Names of what steps have by an estimate, such as "wind".
    std::vector<std::string> estimated{};
    //! Plants grow: each step has the part of its time for which they are as
    //! they stand.
    bool grows = false;

    double beam() const;      //!< PAR on a mean day [J m-2 day-1]
    double diffuse() const;   //!< PAR on a mean day [J m-2 day-1]
    double incident() const;  //!< beam + diffuse [J m-2 day-1]

    double lit_seconds() const;  //!< of all steps with any light [s]

    //! Returns the hours of the day with the sun up or light on any day, from
    //! the first to the last [h].
    std::vector<double> hours() const;

    std::vector<Date> dates() const;  //!< with any step, in order

    //! Returns the steps at each of hours(), and on each of dates(), by number.
    std::vector<std::vector<std::size_t>> steps_of_hours() const;
    std::vector<std::vector<std::size_t>> steps_of_dates() const;
};

//! Clear days of a site by the trapezoidal rule: the first and last instants
//! stand for half a step. Instants with the sun below the horizon are left out;
//! the series is empty if it stays there. par_fraction is PAR over all solar
//! radiation, the same for beam and diffuse.
//! @throws Error if the step does not divide the span.
LightSeries clear_days(const Site& site, const DaySpan& span,
                       double par_fraction);

//! The time with sun on a date, by the local clock and without refraction.
//! The day is the one around the noon that is nearest to 12:00.
struct Daylight {
    double noon = 12;               //!< when the sun is highest [h]
    double elevation = 0;           //!< elevation of the sun then [deg]
    std::optional<double> sunrise;  //!< [h]; none if it is up, or down, all day
    std::optional<double> sunset;   //!< [h]; none if it is up, or down, all day
};

Daylight daylight(const Site& site, const Date& date);

//! Returns how far the local clock is ahead of the mean sun's [h], from -12 to
//! 12: but for the equation of time, noon comes so much later than 12:00.
double clock_ahead(const Site& site);

//! Returns the part of the light of clear days that comes before the start and
//! after the end of a span, from 0 to 1; 0 if there is no light.
double share_left_out(const Site& site, const DaySpan& span);

}  // namespace ideotype
