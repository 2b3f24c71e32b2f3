#include "travel.hpp"

#include <algorithm>
#include <limits>

namespace ideotype {

namespace {

Met travel_periodic(const Scene& scene, PhotonPacket& packet, Hit& hit) {
    constexpr double never = std::numeric_limits<double>::infinity();
    // Rounding may hide a face at the very end of a segment or, as its image,
    // at the very start of the next one. Both look a little over the seam.
    const double seam = scene.clearance() / 2;
    double before = 0;
    glm::dvec3& p = packet.position;
    const glm::dvec3& d = packet.direction;
    const auto to_side = [](double x, double dx, double period) {
        return dx > 0 ? (period - x) / dx : dx < 0 ? -x / dx : never;
    };
    for (;;) {
        const double to_x = to_side(p.x, d.x, scene.period_x());
        const double to_y = to_side(p.y, d.y, scene.period_y());
        const double end = d.z < 0 ? scene.soil() : scene.top();
        const double to_z = std::max(0.0, (end - p.z) / d.z);
        const double distance = std::max(0.0, std::min({to_x, to_y, to_z}));
        if (scene.intersect(p - before * d, d, before + distance + seam, hit))
            return Met::face;
        before = seam;
        if (to_z <= to_x && to_z <= to_y) {
            p += to_z * d;
            p.z = end;
            return d.z < 0 ? Met::soil : Met::sky;
        }
        p += distance * d;
        if (to_x < to_y)
            p.x = d.x > 0 ? 0 : scene.period_x();
        else
            p.y = d.y > 0 ? 0 : scene.period_y();
    }
}

Met travel_isolated(const Scene& scene, PhotonPacket& packet, Hit& hit) {
    glm::dvec3& p = packet.position;
    const glm::dvec3& d = packet.direction;
    const double margin = scene.clearance() / 2;
    const auto [lower, upper] = scene.box();
    const Box box{lower - margin, upper + margin};
    double to_soil = d.z < 0 ? std::max(0.0, (scene.soil() - p.z) / d.z)
                             : std::numeric_limits<double>::infinity();
    // From the soil far away the way to the box is long: single precision
    // must begin only there.
    if (const auto inside = clip(box, p, d)) {
        const double first = inside->first;
        const double last = std::min(inside->last, to_soil + margin);
        if (scene.intersect(p + first * d, d, last - first, hit))
            return Met::face;
    }
    if (d.z > 0) return Met::sky;
    p += to_soil * d;
    p.z = scene.soil();
    return Met::soil;
}

}  // namespace

Met travel(const Scene& scene, PhotonPacket& packet, Hit& hit) {
    return scene.boundary() == Boundary::periodic
               ? travel_periodic(scene, packet, hit)
               : travel_isolated(scene, packet, hit);
}

}  // namespace ideotype
