// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/climate/light_series.hpp"

namespace ideotype {

//! Pressure of the standard atmosphere [kPa] at an elevation [m].
double standard_pressure(double elevation);

//! Longwave radiation of the sky [W m-2]: that of a clear sky (Brutsaert 1975,
//! doi:10.1029/WR011i005p00742) and of clouds (Crawford and Duchon 1999,
//! doi:10.1175/1520-0450(1999)038<0474:AIPFEE>2.0.CO;2),
//!
//!     [(1 - s) + 1.24 s (e / T)^(1/7)] sigma T^4
//!
//! @param temperature of the air [deg C]
//! @param vapour pressure e of it [hPa], where T is in K
//! @param clearness s: light over that of a clear sky, 0 to 1
double sky_longwave(double temperature, double vapour, double clearness);

//! Gives each step the wind, pressure and longwave radiation that weather does
//! not tell: 2 m s-1 at a height of 2 m (Allen et al. 1998, FAO 56), that of
//! the elevation, and sky_longwave(), at night and with a low sun with the
//! clearness of the daylight before. Air without temperature or humidity is
//! that of clear days. The series then tells what has been estimated.
//! @param par_fraction PAR over all solar radiation of the clear sky
void estimate_air(LightSeries& series, const Site& site, double par_fraction);

}  // namespace ideotype
