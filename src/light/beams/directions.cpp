// SPDX-License-Identifier: Apache-2.0
#include "directions.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "ideotype/core/contract.hpp"

namespace ideotype {

glm::dvec3 not_level(glm::dvec3 d) {
    constexpr double least = 1e-7;
    if (std::abs(d.z) < least) d.z = std::copysign(least, d.z);
    return d;
}

glm::dvec3 lambertian(const glm::dvec3& n, double u, double v) {
    IDEOTYPE_EXPECT(u >= 0 && u < 1 && v >= 0 && v < 1);
    IDEOTYPE_EXPECT(std::abs(glm::dot(n, n) - 1) < 1e-6);
    const double sign = std::copysign(1.0, n.z);
    const double a = -1 / (sign + n.z);
    const double b = n.x * n.y * a;
    const glm::dvec3 s{1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    const glm::dvec3 t{b, sign + n.y * n.y * a, -n.y};
    const double r = std::sqrt(u);
    const double phi = 2 * std::numbers::pi * v;
    const double x = r * std::cos(phi);
    const double y = r * std::sin(phi);
    const double z = std::sqrt(1 - u);
    return not_level(x * s + y * t + z * n);
}

}  // namespace ideotype
