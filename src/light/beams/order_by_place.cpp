// SPDX-License-Identifier: Apache-2.0
#include "order_by_place.hpp"

#include <algorithm>
#include <numeric>

#include "ideotype/core/mapped.hpp"

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

std::vector<std::uint32_t> order_by_place(
    const RayScene& scene, const std::vector<glm::dvec3>& points) {
    unsigned bits = 1;  // bits per coordinate
    while (bits < 8 && std::size_t{1} << (3 * bits) < points.size()) ++bits;
    const bool is_periodic = scene.boundary() == Boundary::periodic;
    const glm::dvec3 all{is_periodic ? scene.period_x() : scene.box().upper.x,
                         is_periodic ? scene.period_y() : scene.box().upper.y,
                         scene.top()};
    glm::dvec3 per_metre;
    for (int i = 0; i < 3; ++i)
        per_metre[i] = all[i] > 0 ? static_cast<double>(1 << bits) / all[i] : 0;
    const auto block_of = [&](const glm::dvec3& point) {
        const glm::dvec3 p = scene.wrapped(point) * per_metre;
        const auto part = [&](double x) {
            return spread(static_cast<std::uint32_t>(
                std::clamp(x, 0., static_cast<double>((1 << bits) - 1))));
        };
        return part(p.x) << 2 | part(p.y) << 1 | part(p.z);
    };
    const std::vector<std::uint32_t> blocks = mapped(points, block_of);
    std::vector<std::uint32_t> ends((std::size_t{1} << (3 * bits)) + 1);
    for (const std::uint32_t block : blocks) ++ends[block + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::uint32_t> order(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        order[ends[blocks[i]]++] = i;
    return order;
}

}  // namespace ideotype
