// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <compare>
#include <optional>
#include <string>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! A location on Earth and its clear-sky atmosphere.
struct Site {
    std::string name;
    double latitude = 0;         //!< north positive [deg]
    double longitude = 0;        //!< east positive [deg]
    double utc_offset = 0;       //!< offset from UTC of the local clock [h]
    double elevation = 0;        //!< height above sea level [m]
    double linke_turbidity = 3;  //!< from 2, very clear, to 7, hazy [-]
    std::string weather{};       //!< name of the weather file, if any
    double weight = 1;           //!< weight among other sites
};

//! A day of the Gregorian calendar.
struct Date {
    int year = 2025;
    int month = 1;
    int day = 1;

    auto operator<=>(const Date&) const = default;
};

inline std::chrono::sys_days to_day(const Date& date) {
    return std::chrono::year{date.year} /
           std::chrono::month{static_cast<unsigned>(date.month)} /
           std::chrono::day{static_cast<unsigned>(date.day)};
}

//! Returns a date in another year; 29 February becomes the 28th in years
//! without it.
inline Date in_year(const Date& date, int year) {
    const bool is_there =
        date.month != 2 || date.day != 29 || std::chrono::year{year}.is_leap();
    return {year, date.month, is_there ? date.day : 28};
}

std::string to_string(const Date& date);  //!< such as 2025-08-07

//! Parses a date such as 2025-08-07; returns nothing if there is no such date.
std::optional<Date> to_date(const std::string& text);

//! The direction of the sun's centre, without refraction.
struct SunPosition {
    double zenith = 0;   //!< angle to the vertical [deg], 90 at the horizon
    double azimuth = 0;  //!< angle clockwise from north [deg]
};

//! Returns the position of the sun at a local clock time, hour in [0, 24] or
//! beyond, by the PSA algorithm with the 2020 coefficients (Blanco et al. 2020,
//! doi:10.1016/j.solener.2020.10.084), parallax included: within 30 arc seconds
//! from 2020 to 2050.
SunPosition sun_position(const Site& site, const Date& date, double hour);

//! Returns the direction in which the light of a sun travels (x east, y north,
//! z up): -(sin z sin a, sin z cos a, cos z) at zenith angle z and azimuth a.
glm::dvec3 beam_direction(const SunPosition& sun);

//! Irradiance of a horizontal surface [W m-2].
struct Irradiance {
    double beam = 0;
    double diffuse = 0;
};

//! Returns the extraterrestrial irradiance normal to the rays on a date [W m-2]
//! (Spencer 1971), with a solar constant of 1361.1 W m-2.
double extraterrestrial_normal(const Date& date);

//! Returns the broadband irradiance under a cloudless sky from the Linke
//! turbidity (Ineichen and Perez 2002, doi:10.1016/S0038-092X(02)00045-2, with
//! the corrections of Perez et al. 2002, doi:10.1016/S0038-092X(02)00122-6);
//! zero with the sun below the horizon. Neither part is negative.
Irradiance clear_sky(const Site& site, const Date& date,
                     const SunPosition& sun);

//! Returns the diffuse fraction of the global light in an hour from its
//! clearness index, which is global over extraterrestrial horizontal irradiance
//! (Erbs, Klein and Duffie 1982, doi:10.1016/0038-092X(82)90302-4). Limits are
//! those of pvlib: the cosine of the zenith angle in the correlation is at
//! least 0.065 and the index at most 1. Below a solar elevation of 3 deg all
//! light is diffuse.
//!
//! @param global light on a horizontal plane [W m-2]
//! @param extraterrestrial_normal irradiance of a plane that faces the sun [W
//! m-2]
//! @param zenith angle of the sun to the vertical [deg]
double diffuse_fraction(double global, double extraterrestrial_normal,
                        double zenith);

//! Returns the PAR fraction of solar radiation. Clouds absorb more near
//! infrared than PAR, so this fraction rises as the clearness index k falls:
//! photons of PAR over solar energy are 1.832 - 0.191 ln k + 0.099 cos z [umol
//! J-1] at the zenith angle z (Alados, Foyo-Moreno and Alados-Arboledas 1996,
//! Agricultural and Forest Meteorology 78, 121-131,
//! doi:10.1016/0168-1923(95)02245-7). The clearness index depends on the solar
//! radiation and therefore on the fraction: both equations are solved together.
//! The cosine and the index are limited as in diffuse_fraction(), and the index
//! is at least 0.05. The fraction is therefore between 0.40 and 0.55, also at
//! night.
//!
//! @param par global PAR on a horizontal plane [W m-2]
//! @param extraterrestrial_normal irradiance of a plane that faces the sun [W
//! m-2]
//! @param zenith angle of the sun to the vertical [deg]
double par_share(double par, double extraterrestrial_normal, double zenith);

}  // namespace ideotype
