// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace ideotype {

//! The two factors of the CIE clear sky, see relative_radiance().

//! Scattering at an angle from the sun [rad].
inline double indicatrix(double to_sun) {
    const double c = std::cos(to_sun);
    return 0.91 + 10 * std::exp(-3 * to_sun) + 0.45 * c * c;
}

//! Brightening from the zenith to the horizon.
inline double gradation(double cos_zenith) {
    return cos_zenith > 0 ? 1 - std::exp(-0.32 / cos_zenith) : 1;
}

}  // namespace ideotype
