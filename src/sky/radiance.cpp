#include "ideotype/sky/radiance.hpp"

#include <algorithm>
#include <cmath>

#include "clear_radiance.hpp"

namespace ideotype {

double relative_radiance(const SkyRadiance& sky, const Vec3& travel) {
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
    const Vec3 sun = beam_direction(sky.sun);
    const double cos_to_sun =
        travel.x * sun.x + travel.y * sun.y + travel.z * sun.z;
    return indicatrix(std::acos(std::clamp(cos_to_sun, -1.0, 1.0))) *
           gradation(cos_zenith);
}

}  // namespace ideotype
