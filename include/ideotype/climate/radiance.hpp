// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/climate/sun.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! How the brightness of the sky changes with direction.
enum class SkyModel { uniform, overcast, clear };

//! The shape of a sky's radiance.
struct SkyRadiance {
    SkyModel model = SkyModel::uniform;
    SunPosition sun;  //!< of a clear sky; azimuth in the axes of the caller
};

//! Radiance of the light that travels in a direction (unit length, z up), up
//! to a factor; zero if it travels upwards. With z the angle of the place it
//! comes from to the zenith and g that to the sun [rad]:
//!
//! - uniform: 1
//! - overcast: (1 + 2 cos z) / 3 (Moon and Spencer 1942; CIE standard
//!   overcast sky, ISO 15469:2004)
//! - clear: (0.91 + 10 exp(-3 g) + 0.45 cos^2 g) (1 - exp(-0.32 / cos z))
//!   (Kittler 1967; CIE publication 22, 1973; ISO 15469:2004)
double relative_radiance(const SkyRadiance& sky, const glm::dvec3& travel);

}  // namespace ideotype
