// SPDX-License-Identifier: Apache-2.0
#include "ideotype/climate/diffuse_fraction.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/core/units.hpp"

namespace ideotype {

double diffuse_fraction(double global, double extraterrestrial_normal,
                        double zenith) {
    if (zenith > 87) return 1;
    const double cosine = std::max(std::cos(zenith * degree), 0.065);
    const double k =
        std::clamp(global / (extraterrestrial_normal * cosine), 0.0, 1.0);
    if (k <= 0.22) return 1 - 0.09 * k;
    if (k > 0.8) return 0.165;
    return 0.9511 + k * (-0.1604 + k * (4.388 + k * (-16.638 + k * 12.336)));
}

}  // namespace ideotype
