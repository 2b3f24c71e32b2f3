// SPDX-License-Identifier: Apache-2.0
#include "ideotype/climate/sun.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

//! Returns the days since noon of 1 January 2000, in universal time.
double days_since_2000(const Date& date, double universal_hour) {
    const auto whole_days = (to_day(date) - to_day({2000, 1, 1})).count();
    return static_cast<double>(whole_days) - 0.5 + universal_hour / 24;
}

//! A direction on the celestial sphere [rad].
struct Equatorial {
    double right_ascension;
    double declination;
};

//! Returns the apparent position of the sun by the PSA algorithm with the 2020
//! coefficients (Blanco et al. 2020), see sun_position().
Equatorial apparent_sun(double days) {
    const double node = 2.267127827 - 9.300339267e-4 * days;
    const double mean_longitude = 4.895036035 + 1.720279602e-2 * days;
    const double mean_anomaly = 6.239468336 + 1.720200135e-2 * days;
    const double longitude = mean_longitude +
                             3.338320972e-2 * std::sin(mean_anomaly) +
                             3.497596876e-4 * std::sin(2 * mean_anomaly) -
                             1.544353226e-4 - 8.689729360e-6 * std::sin(node);
    const double obliquity = 4.090904909e-1 - 6.213605399e-9 * days +
                             4.418094944e-5 * std::cos(node);
    return {
        std::atan2(std::cos(obliquity) * std::sin(longitude),
                   std::cos(longitude)),
        std::asin(std::sin(obliquity) * std::sin(longitude)),
    };
}

constexpr double solar_constant = 1361.1;       //!< [W m-2]
constexpr double sea_level_pressure = 1013.25;  //!< [hPa]

//! Returns the days since 1 January of the same year.
int day_of_year(const Date& date) {
    return static_cast<int>((to_day(date) - to_day({date.year, 1, 1})).count());
}

//! Returns the pressure of the standard atmosphere [hPa] at an elevation [m].
double standard_pressure(double elevation) {
    return std::pow((44331.514 - elevation) / 11880.516, 1 / 0.1902632);
}

//! Returns the relative optical air mass at an elevation, 1 for a zenith sun at
//! sea level (Kasten and Young 1989, doi:10.1364/AO.28.004735).
double air_mass(double zenith, double elevation) {
    const double relative =
        1 / (std::cos(zenith * degree) +
             0.50572 * std::pow(96.07995 - zenith, -1.6364));
    return relative * standard_pressure(elevation) / sea_level_pressure;
}

//! Returns the cosine of the zenith angle [deg] with the lower bound that
//! clearness indices use.
double bounded_cosine(double zenith) {
    return std::max(std::cos(zenith * degree), 0.065);
}

//! Returns global over extraterrestrial horizontal irradiance, from 0 to 1.
double clearness_index(double global, double extraterrestrial_normal,
                       double zenith) {
    return std::clamp(
        global / (extraterrestrial_normal * bounded_cosine(zenith)), 0.0, 1.0);
}

}  // namespace

SunPosition sun_position(const Site& site, const Date& date, double hour) {
    const double universal_hour = hour - site.utc_offset;
    const double days = days_since_2000(date, universal_hour);
    const Equatorial sun = apparent_sun(days);

    // Hour angle from the Greenwich mean sidereal time.
    const double greenwich_sidereal_hours =
        6.697096103 + 6.570984737e-2 * days + universal_hour;
    const double hour_angle =
        (greenwich_sidereal_hours * 15 + site.longitude) * degree -
        sun.right_ascension;
    const double latitude = site.latitude * degree;

    const double cos_zenith =
        std::cos(latitude) * std::cos(hour_angle) * std::cos(sun.declination) +
        std::sin(sun.declination) * std::sin(latitude);
    const double zenith = std::acos(std::clamp(cos_zenith, -1.0, 1.0));
    // The sun appears lower from the surface than from the centre of the Earth.
    // The parallax is the mean radius over the astronomical unit.
    const double parallax = 6371.01 / 149597890.0 * std::sin(zenith);

    const double azimuth = std::atan2(
        -std::sin(hour_angle), std::tan(sun.declination) * std::cos(latitude) -
                                   std::sin(latitude) * std::cos(hour_angle));
    return {
        (zenith + parallax) / degree,
        (azimuth < 0 ? azimuth + 2 * std::numbers::pi : azimuth) / degree,
    };
}

glm::dvec3 beam_direction(const SunPosition& sun) {
    const double zenith = sun.zenith * degree;
    const double azimuth = sun.azimuth * degree;
    return {
        -std::sin(zenith) * std::sin(azimuth),
        -std::sin(zenith) * std::cos(azimuth),
        -std::cos(zenith),
    };
}

double extraterrestrial_normal(const Date& date) {
    const double b = 2 * std::numbers::pi * day_of_year(date) / 365;
    return solar_constant *
           (1.00011 + 0.034221 * std::cos(b) + 0.00128 * std::sin(b) +
            0.000719 * std::cos(2 * b) + 0.000077 * std::sin(2 * b));
}

Irradiance clear_sky(const Site& site, const Date& date,
                     const SunPosition& sun) {
    if (sun.zenith >= 90) return {};
    const double extraterrestrial = extraterrestrial_normal(date);
    const double cos_zenith = std::cos(sun.zenith * degree);
    const double mass = air_mass(sun.zenith, site.elevation);
    const double turbidity = site.linke_turbidity;

    // Global light on a horizontal plane.
    const double fh1 = std::exp(-site.elevation / 8000);
    const double fh2 = std::exp(-site.elevation / 1250);
    const double cg1 = 5.09e-5 * site.elevation + 0.868;
    const double cg2 = 3.92e-5 * site.elevation + 0.0387;
    const double global = cg1 * extraterrestrial * cos_zenith *
                          std::exp(-cg2 * mass * (fh1 + fh2 * (turbidity - 1)));

    // Beam on a plane that faces the sun.
    const double b = 0.664 + 0.163 / fh1;
    const double beam_normal =
        b * extraterrestrial * std::exp(-0.09 * mass * (turbidity - 1));
    // Some light is always scattered, even where the equation for the beam
    // leaves none.
    const double largest_beam_share =
        1 - (0.1 - 0.2 * std::exp(-turbidity)) / (0.1 + 0.882 / fh1);
    const double beam =
        std::min(beam_normal * cos_zenith,
                 global * std::clamp(largest_beam_share, 0.0, 1.0));
    return {beam, global - beam};
}

double diffuse_fraction(double global, double extraterrestrial_normal,
                        double zenith) {
    if (zenith > 87) return 1;
    const double k = clearness_index(global, extraterrestrial_normal, zenith);
    if (k <= 0.22) return 1 - 0.09 * k;
    if (k > 0.8) return 0.165;
    return 0.9511 + k * (-0.1604 + k * (4.388 + k * (-16.638 + k * 12.336)));
}

double par_share(double par, double extraterrestrial_normal, double zenith) {
    // Solve by fixed-point iteration. Each step reduces the error of the share
    // by a factor of at least nine: the ratio of photons to energy over 0.191.
    constexpr int steps = 18;
    double share = 0.45;
    for (int i = 0; i < steps; ++i) {
        const double k =
            clearness_index(par / share, extraterrestrial_normal, zenith);
        share = (1.832 - 0.191 * std::log(std::max(k, 0.05)) +
                 0.099 * bounded_cosine(zenith)) /
                mol_per_mj_par;
    }
    return share;
}

}  // namespace ideotype
