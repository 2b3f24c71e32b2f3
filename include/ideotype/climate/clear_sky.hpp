// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/climate/site.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! Irradiance of a horizontal surface [W m-2].
struct Irradiance {
    double beam = 0;
    double diffuse = 0;
};

//! Extraterrestrial irradiance normal to the rays on a date [W m-2] (Spencer
//! 1971), with a solar constant of 1361.1 W m-2.
double extraterrestrial_normal(const Date& date);

//! Broadband irradiance under a cloudless sky from the Linke turbidity
//! (Ineichen and Perez 2002, doi:10.1016/S0038-092X(02)00045-2, with the
//! corrections of Perez et al. 2002, doi:10.1016/S0038-092X(02)00122-6);
//! zero with the sun below the horizon. Neither part is negative.
Irradiance clear_sky(const Site& site, const Date& date,
                     const SunPosition& sun);

//! Diffuse over global light of an hour by its clearness index, which is
//! global over extraterrestrial horizontal irradiance (Erbs, Klein and Duffie
//! 1982, doi:10.1016/0038-092X(82)90302-4). Limits are those of pvlib: the
//! cosine of the zenith angle is at least 0.065 and the index at most 1 in
//! the correlation, and lower than 3 deg the sun has no beam.
//!
//! @param global [W m-2]
//! @param extraterrestrial_normal on a plane that faces the sun [W m-2]
//! @param zenith of the sun [deg]
double diffuse_fraction(double global, double extraterrestrial_normal,
                        double zenith);

}  // namespace ideotype
