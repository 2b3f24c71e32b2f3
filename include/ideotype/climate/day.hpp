#pragma once

#include <vector>

#include "ideotype/climate/clear_sky.hpp"
#include "ideotype/climate/site.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! Which part of which day counts.
struct DaySpan {
    Date date;
    double start = 7;          //!< local clock [h]
    double end = 20;           //!< local clock [h], after start
    double step_minutes = 30;  //!< divides end - start
};

//! One instant that stands for the time around it.
struct TimeStep {
    double hour = 0;     //!< local clock [h]
    double seconds = 0;  //!< the time that it stands for [s]
    SunPosition sun;
    Irradiance par;  //!< photosynthetically active, horizontal [W m-2]
};

//! The light of a day as weighted instants, by the trapezoidal rule: the
//! first and last instants stand for half a step. Instants with the sun
//! below the horizon are left out; they carry no light.
struct Day {
    std::vector<TimeStep> steps;

    double beam() const;      //!< PAR of the day [J m-2]
    double diffuse() const;   //!< PAR of the day [J m-2]
    double incident() const;  //!< beam + diffuse [J m-2]
};

//! The clear day of a site; empty if the sun stays below the horizon.
//! par_fraction is PAR over all solar radiation, the same for beam and
//! diffuse.
//! @throws Error if the step does not divide the span.
Day clear_day(const Site& site, const DaySpan& span, double par_fraction);

}  // namespace ideotype
