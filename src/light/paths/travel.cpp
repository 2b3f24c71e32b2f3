// SPDX-License-Identifier: Apache-2.0
#include "travel.hpp"

#include <algorithm>
#include <limits>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Returns the hit on soil or sky at the end of a ray that meets no face.
Hit end_at(const glm::dvec3& point, const glm::dvec3& direction) {
    return {point, {0, 0, 1}, direction.z < 0 ? Hit::soil : Hit::sky};
}

Hit travel_periodic(const RayScene& scene, glm::dvec3 p, const glm::dvec3& d,
                    std::uint32_t pose) {
    constexpr double never = std::numeric_limits<double>::infinity();
    // Rounding may hide a face at the very end of a segment or, as its image,
    // at the very start of the next one. Both segments therefore overlap
    // slightly at the seam.
    const double seam = scene.clearance() / 2;
    double before = 0;
    const auto to_side = [](double x, double dx, double period) {
        return dx > 0 ? (period - x) / dx : dx < 0 ? -x / dx : never;
    };
    Hit hit;
    for (;;) {
        const double to_x = to_side(p.x, d.x, scene.period_x());
        const double to_y = to_side(p.y, d.y, scene.period_y());
        const double end = d.z < 0 ? scene.soil() : scene.top();
        const double to_z = std::max(0.0, (end - p.z) / d.z);
        const double distance = std::max(0.0, std::min({to_x, to_y, to_z}));
        if (scene.intersect(p - before * d, d, before + distance + seam, hit,
                            pose))
            return hit;
        before = seam;
        p += distance * d;
        if (to_z <= to_x && to_z <= to_y) return end_at({p.x, p.y, end}, d);
        if (to_x < to_y)
            p.x = d.x > 0 ? 0 : scene.period_x();
        else
            p.y = d.y > 0 ? 0 : scene.period_y();
    }
}

Hit travel_isolated(const RayScene& scene, const glm::dvec3& p,
                    const glm::dvec3& d) {
    const double margin = scene.clearance() / 2;
    const auto [lower, upper] = scene.box();
    const Box box{lower - margin, upper + margin};
    const double to_soil = d.z < 0 ? std::max(0.0, (scene.soil() - p.z) / d.z)
                                   : std::numeric_limits<double>::infinity();
    // A path from distant soil is too long for single precision, so Embree
    // traces only the part inside the bounding box.
    Hit hit;
    if (const auto inside = clip(box, p, d)) {
        const double first = inside->first;
        const double last = std::min(inside->last, to_soil + margin);
        if (scene.intersect(p + first * d, d, last - first, hit)) return hit;
    }
    if (d.z > 0) return end_at(p, d);
    const glm::dvec3 end = p + to_soil * d;
    return end_at({end.x, end.y, scene.soil()}, d);
}

}  // namespace

Hit travel(const RayScene& scene, glm::dvec3 from, const glm::dvec3& direction,
           std::uint32_t pose) {
    IDEOTYPE_EXPECT(direction.z != 0);
    return scene.boundary() == Boundary::periodic
               ? travel_periodic(scene, from, direction, pose)
               : travel_isolated(scene, from, direction);
}

}  // namespace ideotype
