#include "tracer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "directions.hpp"

namespace ideotype {

namespace {

//! Dimensions of a sampler that first hits use at most; scattered light has
//! the others.
std::size_t dimensions_of_first_hits(Boundary boundary) {
    return boundary == Boundary::periodic ? 4 : 8;
}

//! What a surface keeps of a packet; the packet goes on with the rest.
//! While the scattered part is a large share of what the path started with,
//! the surface keeps exactly its absorptance. A small scattered part is not
//! worth following: instead all or nothing is scattered, with the right odds.
//! Both rules are unbiased and lose no energy. `choice` is uniform in [0, 1)
//! and is so again afterwards, for the next choice.
double absorb_and_continue(PhotonPacket& packet, double started,
                           double scattered, double& choice) {
    constexpr double worth_following = 0.25;
    if (packet.energy * scattered > worth_following * started) {
        const double kept = packet.energy * (1 - scattered);
        packet.energy -= kept;
        return kept;
    }
    if (choice < scattered) {
        choice /= scattered;
        return 0;
    }
    return std::exchange(packet.energy, 0.0);
}

}  // namespace

void Tracer::trace(const FirstHits& hits, PathSampler& sampler,
                   double path_energy, Ledger& ledger) const {
    const std::size_t first = dimensions_of_first_hits(scene_.boundary());
    sampler.begin(0, first);
    const double start = sampler.next();
    std::vector<double> sent_on;
    sent_on.reserve(hits.size());
    double whole = 0;
    for (const FirstHit& hit : hits) {
        sent_on.push_back(surface(hit.group).scattered());
        whole += sent_on.back();
    }
    if (whole < 1) {
        double passed = 0;
        for (double& part : sent_on) {
            passed += part;
            part = passed > start ? 1 : 0;
            passed -= part;
        }
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
        sent_on[i] *= hits[i].energy;
        ledger.arrive(hits[i], sent_on[i]);
    }
    const double all = ledger.close().sent_on;
    if (!(all > 0)) return;
    const auto paths = static_cast<std::uint32_t>(
        std::max(1., std::ceil(all / path_energy - 1e-9)));
    const double energy = all / paths;
    // Rounding must not lose the last one.
    std::size_t last = hits.size() - 1;
    while (sent_on[last] == 0) --last;
    double passed = 0;
    std::uint32_t path = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        passed += sent_on[i];
        const bool is_last = i == last;
        for (; path < paths && ((start + path) * energy < passed || is_last);
             ++path) {
            sampler.begin(path, first + 1);
            PhotonPacket packet;
            packet.energy = energy;
            const double choice = sampler.next();
            scatter(packet, hits.at(i), hits[i].is_adaxial, choice, sampler);
            follow(packet, sampler, ledger);
        }
    }
    ledger.close();
}

Lambertian Tracer::surface(std::uint32_t group) const {
    if (group == Hit::sky) return {};
    if (group == Hit::soil) return {optics_.soil_albedo, 0};
    return optics_.of(groups_[group].tissue);
}

void Tracer::follow(PhotonPacket packet, PathSampler& sampler,
                    Ledger& ledger) const {
    const double started = packet.energy;
    while (packet.energy > 0) {
        ledger.count_ray();
        const Hit hit = travel(scene_, packet.position, packet.direction);
        const bool is_adaxial = glm::dot(packet.direction, hit.normal) < 0;
        const double scattered = surface(hit.group).scattered();
        double choice = scattered > 0 ? sampler.next() : 0;
        ledger.keep(hit, is_adaxial,
                    scattered > 0 ? absorb_and_continue(packet, started,
                                                        scattered, choice)
                                  : std::exchange(packet.energy, 0.0));
        if (packet.energy > 0)
            scatter(packet, hit, is_adaxial, choice, sampler);
    }
}

void Tracer::scatter(PhotonPacket& packet, const Hit& hit, bool is_adaxial,
                     double choice, PathSampler& sampler) const {
    const Lambertian face = surface(hit.group);
    const bool is_reflected =
        face.transmittance == 0 || choice * face.scattered() < face.reflectance;
    const glm::dvec3 n = is_adaxial == is_reflected ? hit.normal : -hit.normal;
    const double u = sampler.next();
    packet.position = scene_.offset_origin(hit.position, n);
    packet.direction = lambertian(n, u, sampler.next());
}

}  // namespace ideotype
