// SPDX-License-Identifier: Apache-2.0
#include "ideotype/climate/sun.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

//! Days since noon of 1 January 2000, in universal time.
double days_since_2000(const Date& date, double universal_hour) {
    const auto whole_days = (day_of(date) - day_of({2000, 1, 1})).count();
    return static_cast<double>(whole_days) - 0.5 + universal_hour / 24;
}

//! Direction on the celestial sphere [rad].
struct Equatorial {
    double right_ascension;
    double declination;
};

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

}  // namespace

SunPosition sun_position(const Site& site, const Date& date, double hour) {
    const double universal_hour = hour - site.utc_offset;
    const double days = days_since_2000(date, universal_hour);
    const Equatorial sun = apparent_sun(days);

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
    // Seen from the surface the sun stands lower than from the centre of the
    // Earth: mean radius over astronomical unit.
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

}  // namespace ideotype
