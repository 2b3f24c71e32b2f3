// SPDX-License-Identifier: Apache-2.0
#include "first_hits.hpp"

#include <utility>

#include <glm/geometric.hpp>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "order_by_place.hpp"
#include "paths/travel.hpp"

namespace ideotype {

FirstHits::FirstHits(const RayScene& scene, const DepthBuffer& buffer,
                     std::size_t randomisation, double energy)
    : scene_(scene), buffer_(&buffer), randomisation_(randomisation) {
    IDEOTYPE_EXPECT(energy >= 0);
    const std::vector<std::uint32_t>& groups = scene.surfaces().face_group;
    hits_.reserve(buffer.points());
    for (std::size_t i = 0; i < buffer.points(); ++i) {
        const DepthBuffer::Triangle seen = buffer.triangle(randomisation, i);
        hits_.push_back({seen.is_soil() ? Hit::soil : groups[seen.face()],
                         seen.number(), buffer.height(randomisation, i),
                         seen.is_adaxial(), true, energy});
    }
}

FirstHits::FirstHits(const RayScene& scene, const Launcher& launcher,
                     PathSampler& sampler, std::uint32_t rays, double energy)
    : scene_(scene) {
    IDEOTYPE_EXPECT(energy >= 0);
    hits_.reserve(rays);
    points_.reserve(rays);
    for (std::uint32_t i = 0; i < rays; ++i) {
        sampler.begin(i);
        const PhotonPacket packet = launcher.launch(sampler, energy);
        Hit hit;
        hit.group = Hit::sky;
        if (packet.energy > 0)
            hit = travel(scene, packet.position, packet.direction,
                         launcher.pose());
        hits_.push_back({hit.group, hit.triangle,
                         static_cast<float>(hit.position.z),
                         glm::dot(packet.direction, hit.normal) < 0,
                         !packet.is_scattered, packet.energy});
        points_.push_back(hit);
    }
    order();
}

void FirstHits::order() {
    std::vector<FirstHit> hits;
    std::vector<Hit> points;
    hits.reserve(hits_.size());
    points.reserve(hits_.size());
    for (const std::uint32_t i :
         order_by_place(scene_, mapped(points_, &Hit::position))) {
        hits.push_back(hits_[i]);
        points.push_back(points_[i]);
    }
    hits_ = std::move(hits);
    points_ = std::move(points);
}

Hit FirstHits::at(std::size_t i) const {
    IDEOTYPE_EXPECT(i < hits_.size() && hits_[i].group != Hit::sky);
    if (!buffer_) return points_[i];
    Hit hit{buffer_->position(randomisation_, i), {0, 0, 1}, hits_[i].group};
    const DepthBuffer::Triangle seen = buffer_->triangle(randomisation_, i);
    if (seen.is_soil()) {
        hit.position.z = scene_.soil();
        return hit;
    }
    const Surfaces& all = scene_.surfaces();
    hit.triangle = seen.number();
    hit.normal = all.normals[hit.triangle];
    return hit;
}

}  // namespace ideotype
