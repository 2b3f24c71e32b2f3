// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! The days that a series covers, and the part of each day.
struct DaySpan {
    std::vector<Date> dates;   //!< the days in order
    double start = 7;          //!< local clock at the beginning [h]
    double end = 20;           //!< local clock at the end [h], after start
    double step_minutes = 30;  //!< length of a step, which divides end - start
};

//! One instant that represents the time around it.
struct TimeStep {
    double hour = 0;     //!< local clock time, may lie beyond 0 to 24 [h]
    double seconds = 0;  //!< duration represented by the step [s]
    SunPosition sun;
    Irradiance par;  //!< PAR on a horizontal plane [W m-2]
    Date date{};     //!< date on the clock of the weather file, if any
    std::optional<double> temperature{};  //!< temperature of the air [deg C]
    std::optional<double> humidity{};     //!< relative humidity, 0 to 1
    //! Solar radiation other than PAR on a horizontal plane, all counted as
    //! near infrared [W m-2].
    Irradiance nir{};
    std::optional<double> wind{};  //!< wind at LightSeries::wind_height [m s-1]
    std::optional<double> pressure{};  //!< pressure of the air [kPa]
    //! Longwave radiation of the sky on a horizontal plane [W m-2].
    std::optional<double> longwave{};
    std::optional<double> rain{};  //!< rain during the step [mm]
    bool is_late = false;          //!< after silking of growing plants
    //! Opening of stomata relative to that with enough water, see closed().
    double opening = 1;

    bool is_lit() const { return par.beam + par.diffuse > 0; }
};

//! The light of one or more days as a sequence of weighted instants. Instants
//! without light may be omitted.
struct LightSeries {
    std::vector<TimeStep> steps;
    int days = 1;
    double utc_offset = 0;  //!< offset of the clock of `hour` from UTC [h]
    //! Height of wind measurements above the ground [m].
    double wind_height = 10;
    double co2 = 400;  //!< CO2 of the air [umol mol-1]
    //! Names of the variables of steps that are estimated, such as "wind".
    std::vector<std::string> estimated{};
    //! Whether plants grow: each step then represents only the part of its
    //! duration in which plants are at their current age.
    bool grows = false;

    double beam() const;     //!< beam PAR on a mean day [J m-2 day-1]
    double diffuse() const;  //!< diffuse PAR on a mean day [J m-2 day-1]
    //! Returns beam + diffuse PAR [J m-2 day-1].
    double incident() const { return beam() + diffuse(); }

    double lit_seconds() const;  //!< duration of all steps with any light [s]

    //! Returns the hours that have sun or light on any day, in order [h].
    std::vector<double> hours() const;

    //! Dates with at least one step, in order.
    std::vector<Date> dates() const;

    //! Return the indices of the steps at each of hours() and on each of
    //! dates().
    std::vector<std::vector<std::size_t>> steps_of_hours() const;
    std::vector<std::vector<std::size_t>> steps_of_dates() const;
};

//! Computes clear days of a site by the trapezoidal rule: the first and last
//! instants represent half a step. Instants with the sun below the horizon are
//! omitted; the series may be empty. par_fraction is PAR over all solar
//! radiation, for both beam and diffuse light.
//! @throws Error if the step does not divide the span.
LightSeries clear_days(const Site& site, const DaySpan& span,
                       double par_fraction);

//! The sun's times on a date, on the local clock and without refraction. The
//! day is centred on the noon nearest to 12:00.
struct Daylight {
    double noon = 12;               //!< hour at which the sun is highest [h]
    double elevation = 0;           //!< elevation of the sun at noon [deg]
    std::optional<double> sunrise;  //!< hour [h]; none in polar day or night
    std::optional<double> sunset;   //!< hour [h]; none in polar day or night
};

Daylight daylight(const Site& site, const Date& date);

//! Returns the lead of the local clock over mean solar time [h], from -12 to
//! 12. Apart from the equation of time, noon is this much later than 12:00.
double clock_ahead(const Site& site);

//! Returns the fraction of the light of clear days outside a span, before its
//! start or after its end; 0 if there is no light.
double share_left_out(const Site& site, const DaySpan& span);

}  // namespace ideotype
