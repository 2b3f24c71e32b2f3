#include "first_hits.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "travel.hpp"

namespace ideotype {

namespace {

//! Bits of three numbers in turn: blocks that are near each other in space get
//! near numbers (Morton's order).
std::uint32_t interleaved(std::uint32_t x, std::uint32_t y, std::uint32_t z,
                          unsigned bits) {
    std::uint32_t all = 0;
    for (unsigned bit = bits; bit-- > 0;)
        all = all << 3 | (x >> bit & 1) << 2 | (y >> bit & 1) << 1 |
              (z >> bit & 1);
    return all;
}

}  // namespace

FirstHits::FirstHits(const Scene& scene, const DepthBuffer& buffer,
                     std::size_t replicate, double energy)
    : scene_(scene), buffer_(&buffer), replicate_(replicate) {
    const std::vector<std::uint32_t>& groups = scene.surfaces().face_group;
    hits_.reserve(buffer.points());
    for (std::size_t i = 0; i < buffer.points(); ++i) {
        const DepthBuffer::Triangle seen = buffer.triangle(replicate, i);
        hits_.push_back({seen.is_soil() ? Hit::soil : groups[seen.face()],
                         seen.number(), buffer.height(replicate, i),
                         seen.is_adaxial(), true, energy});
    }
}

FirstHits::FirstHits(const Scene& scene, const Launcher& launcher,
                     PathSampler& sampler, std::uint32_t rays, double energy)
    : scene_(scene) {
    hits_.reserve(rays);
    points_.reserve(rays);
    for (std::uint32_t i = 0; i < rays; ++i) {
        sampler.begin(i);
        const PhotonPacket packet = launcher.launch(sampler, energy);
        Hit hit;
        hit.group = Hit::sky;
        if (packet.energy > 0)
            hit = travel(scene, packet.position, packet.direction);
        hits_.push_back({hit.group, hit.triangle,
                         static_cast<float>(hit.position.z),
                         glm::dot(packet.direction, hit.normal) < 0,
                         !packet.is_scattered, packet.energy});
        points_.push_back(hit);
    }
    order_by_place();
}

void FirstHits::order_by_place() {
    // As many bits of each coordinate as make some blocks for each hit.
    unsigned bits = 1;
    while (bits < 8 && std::size_t{1} << (3 * bits) < hits_.size()) ++bits;
    const auto part = [bits](double x, double length) {
        const double all = static_cast<double>(1 << bits);
        return static_cast<std::uint32_t>(
            std::clamp(x / length * all, 0., all - 1));
    };
    const bool is_periodic = scene_.boundary() == Boundary::periodic;
    const double length_x =
        is_periodic ? scene_.period_x() : scene_.box().upper.x;
    const double length_y =
        is_periodic ? scene_.period_y() : scene_.box().upper.y;
    std::vector<std::uint32_t> blocks;
    blocks.reserve(hits_.size());
    std::vector<std::uint32_t> ends((std::size_t{1} << (3 * bits)) + 1);
    for (const Hit& hit : points_) {
        const glm::dvec3 p = scene_.wrapped(hit.position);
        blocks.push_back(interleaved(part(p.x, length_x), part(p.y, length_y),
                                     part(p.z, scene_.top()), bits));
        ++ends[blocks.back() + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<FirstHit> hits(hits_.size());
    std::vector<Hit> points(hits_.size());
    for (std::size_t i = 0; i < hits_.size(); ++i) {
        const std::uint32_t place = ends[blocks[i]]++;
        hits[place] = hits_[i];
        points[place] = points_[i];
    }
    hits_ = std::move(hits);
    points_ = std::move(points);
}

Hit FirstHits::at(std::size_t i) const {
    if (!buffer_) return points_[i];
    Hit hit{buffer_->position(replicate_, i), {0, 0, 1}, hits_[i].group};
    const DepthBuffer::Triangle seen = buffer_->triangle(replicate_, i);
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
