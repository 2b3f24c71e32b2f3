// SPDX-License-Identifier: Apache-2.0
#include "launch.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "beams/directions.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

Launcher::Launcher(const RayScene& scene, const Source& source,
                   double soil_albedo)
    : scene_(scene), source_(source) {
    IDEOTYPE_EXPECT(soil_albedo >= 0 && soil_albedo <= 1);
    if (scene.boundary() == Boundary::isolated) add_portals(soil_albedo);
}

void Launcher::add_portals(double soil_albedo) {
    const auto [lower, upper] = scene_.box();
    const double x = upper.x - lower.x;
    const double y = upper.y - lower.y;
    const double z = upper.z - lower.z;
    portals_.push_back({2, true, From::source, x * y});
    if (lower.z > 0)
        portals_.push_back({2, false, From::soil, soil_albedo * x * y});
    for (const int axis : {0, 1})
        for (const bool is_upper : {false, true}) {
            const double side = (axis == 0 ? y : x) * z;
            // A vertical face sees half of a uniform sky and half of a uniform
            // soil.
            double lit = 0.5;
            if (source_.direction) {
                const glm::dvec3 d = not_level(*source_.direction);
                const double along = axis == 0 ? d.x : d.y;
                lit = std::max(0.0, (is_upper ? -along : along) / -d.z);
            }
            portals_.push_back({axis, is_upper, From::source, side * lit});
            portals_.push_back(
                {axis, is_upper, From::soil, soil_albedo * side / 2});
        }
    std::erase_if(portals_, [](const Portal& p) { return !(p.area > 0); });
    double sum = 0;
    for (const Portal& portal : portals_) sum += portal.area;
    entering_ = sum / scene_.ground_area();
    IDEOTYPE_ENSURE(entering_ >= 0);
}

PhotonPacket Launcher::launch(PathSampler& sampler, double energy) const {
    if (scene_.boundary() == Boundary::periodic) {
        const double x = sampler.next() * scene_.period_x();
        const double y = sampler.next() * scene_.period_y();
        return {{x, y, scene_.top()}, from_above(sampler), energy};
    }
    if (portals_.empty()) return {};
    double left = sampler.next() * entering_ * scene_.ground_area();
    std::size_t chosen = 0;
    while (chosen + 1 < portals_.size() && left >= portals_[chosen].area)
        left -= portals_[chosen++].area;
    return enter(portals_[chosen], sampler, energy);
}

PhotonPacket Launcher::enter(const Portal& portal, PathSampler& sampler,
                             double energy) const {
    const auto& [lower, upper] = scene_.box();
    glm::dvec3 p(0), n(0);  // n points inwards
    for (int i = 0; i < 3; ++i)
        if (i == portal.axis)
            p[i] = portal.is_upper ? upper[i] : lower[i];
        else
            p[i] = lower[i] + sampler.next() * (upper[i] - lower[i]);
    n[portal.axis] = portal.is_upper ? -1 : 1;
    glm::dvec3 d;
    if (portal.from == From::source &&
        (source_.direction || portal.axis == 2)) {
        d = from_above(sampler);
    } else {
        const double u = sampler.next();
        d = lambertian(n, u, sampler.next());
        d.z = std::copysign(d.z, portal.from == From::soil ? 1.0 : -1.0);
        if (portal.from == From::source) {
            energy *= source_.sky.relative_brightness(d);
        } else {
            const double t = p.z / d.z;
            if (!is_lit({p.x - t * d.x, p.y - t * d.y, 0}, sampler)) return {};
        }
    }
    // A packet starts outside the box, where there is no face, so that it can
    // hit a leaf that lies in the face of the box.
    const double back = scene_.clearance() / glm::dot(d, n);
    return {p - back * d, d, energy, portal.from == From::soil};
}

glm::dvec3 Launcher::from_above(PathSampler& sampler) const {
    if (source_.direction) return not_level(*source_.direction);
    const double u = sampler.next();
    return not_level(source_.sky.sample(u, sampler.next()));
}

bool Launcher::is_lit(const glm::dvec3& soil, PathSampler& sampler) const {
    const glm::dvec3 d = from_above(sampler);
    return !clip(scene_.box(), soil, -d);
}

}  // namespace ideotype
