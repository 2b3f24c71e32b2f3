// SPDX-License-Identifier: Apache-2.0
#include "ideotype/climate/radiance.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "clear_radiance.hpp"

namespace ideotype {

double relative_radiance(const SkyRadiance& sky, const glm::dvec3& travel) {
    const double cos_zenith = -travel.z;
    if (cos_zenith < 0) return 0;
    switch (sky.model) {
        case SkyModel::uniform:
            return 1;
        case SkyModel::overcast:
            return (1 + 2 * cos_zenith) / 3;
        case SkyModel::clear:
            break;
    }
    const glm::dvec3 sun = beam_direction(sky.sun);
    const double cos_to_sun = std::clamp(glm::dot(travel, sun), -1.0, 1.0);
    return indicatrix(std::acos(cos_to_sun)) * gradation(cos_zenith);
}

}  // namespace ideotype
