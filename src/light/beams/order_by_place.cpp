// SPDX-License-Identifier: Apache-2.0
#include "order_by_place.hpp"

#include <algorithm>

namespace ideotype {

namespace {

//! Returns the lowest ten bits of a number, each followed by two zeros.
std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 16) & 0x030000FFu;
    x = (x | x << 8) & 0x0300F00Fu;
    x = (x | x << 4) & 0x030C30C3u;
    return (x | x << 2) & 0x09249249u;
}

}  // namespace

Blocks::Blocks(const RayScene& scene, std::size_t points) : scene_(scene) {
    while (bits_ < 8 && count() < points) ++bits_;
    const bool is_periodic = scene.boundary() == Boundary::periodic;
    const glm::dvec3 all{is_periodic ? scene.period_x() : scene.box().upper.x,
                         is_periodic ? scene.period_y() : scene.box().upper.y,
                         scene.top()};
    for (int i = 0; i < 3; ++i)
        per_metre_[i] =
            all[i] > 0 ? static_cast<double>(1 << bits_) / all[i] : 0;
}

std::uint32_t Blocks::at(const glm::dvec3& position) const {
    const glm::dvec3 p = scene_.wrapped(position) * per_metre_;
    const auto part = [&](double x) {
        return spread(static_cast<std::uint32_t>(
            std::clamp(x, 0., static_cast<double>((1 << bits_) - 1))));
    };
    return part(p.x) << 2 | part(p.y) << 1 | part(p.z);
}

}  // namespace ideotype
