// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/climate/light_series.hpp"

namespace ideotype {

//! Returns the pressure of the standard atmosphere at an elevation [m] in kPa.
double standard_pressure(double elevation);

//! Returns the longwave radiation of the sky [W m-2], from a clear sky
//! (Brutsaert 1975, doi:10.1029/WR011i005p00742) and clouds (Crawford and
//! Duchon 1999, doi:10.1175/1520-0450(1999)038<0474:AIPFEE>2.0.CO;2),
//!
//!     [(1 - s) + 1.24 s (e / T)^(1/7)] sigma T^4
//!
//! @param temperature temperature T of the air [deg C], in the equation in K
//! @param vapour vapour pressure e of the air [hPa]
//! @param clearness s: light over that of a clear sky, 0 to 1
double sky_longwave(double temperature, double vapour, double clearness);

//! Gives each step the wind, pressure and longwave radiation that weather does
//! not tell: a wind of 2 m s-1 at a height of 2 m (Allen et al. 1998, FAO 56),
//! the pressure at the elevation, and sky_longwave(), at night and with a low
//! sun with the clearness of the daylight before. If temperature or humidity is
//! unknown, air is that of clear days. The series then lists the estimates.
//! @param par_fraction PAR over all solar radiation of the clear sky
void estimate_air(LightSeries& series, const Site& site, double par_fraction);

}  // namespace ideotype
