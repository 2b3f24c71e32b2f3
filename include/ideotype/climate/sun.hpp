// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/climate/site.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Where the centre of the sun is seen, without refraction.
struct SunPosition {
    double zenith = 0;   //!< [deg], 0 overhead, 90 at the horizon
    double azimuth = 0;  //!< [deg], clockwise from north
};

//! Position of the sun at a local clock time, hour in [0, 24] or beyond, by
//! the PSA algorithm with the 2020 coefficients (Blanco et al. 2020,
//! doi:10.1016/j.solener.2020.10.084), parallax included: within 30 arc
//! seconds from 2020 to 2050.
SunPosition sun_position(const Site& site, const Date& date, double hour);

//! Direction in which the light of this sun travels (x east, y north, z up):
//! -(sin z sin a, sin z cos a, cos z).
glm::dvec3 beam_direction(const SunPosition& sun);

}  // namespace ideotype
