// SPDX-License-Identifier: Apache-2.0
#include "tracer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "beams/directions.hpp"
#include "beams/order_by_place.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "travel.hpp"

namespace ideotype {

namespace {

//! Returns the energy that a surface absorbs from a path, which continues with
//! the rest. While the scattered part is a large share of the path's initial
//! energy, the surface absorbs exactly its absorptance. When that part becomes
//! small, either all or nothing is scattered, at random (Russian roulette).
//! Both rules are unbiased and lose no energy.
//! @param choice number uniform in [0, 1)
double absorb_and_continue(ScatteredPath& path, double scattered,
                           double choice) {
    IDEOTYPE_EXPECT(scattered >= 0 && scattered <= 1 + 1e-12);
    constexpr double worth_following = 0.25;
    if (path.energy * scattered > worth_following * path.started) {
        const double kept = path.energy * (1 - scattered);
        path.energy -= kept;
        return kept;
    }
    if (choice < scattered) return 0;
    return std::exchange(path.energy, 0.0);
}

}  // namespace

Tracer::Tracer(const Counted& counted, const Optics& optics,
               const std::vector<Source>& sources)
    : counted_(counted), scene_(counted.scene) {
    static_assert(Hit::soil == ~std::uint32_t{0} &&
                  Hit::sky == ~std::uint32_t{1});
    surfaces_ = {{optics.soil_albedo, 0.}, {}};
    for (const Group& group : counted.groups)
        surfaces_.push_back(optics.of(group.material));
    for (const Source& source : sources) poses_.push_back(source.pose);
}

void Tracer::arrive(const FirstHits& hits, const Arrival& how, Tally& tally,
                    std::vector<ScatteredPath>& paths,
                    LeafSums& leaf_sums) const {
    IDEOTYPE_EXPECT(how.start >= 0 && how.start < 1);
    IDEOTYPE_EXPECT(how.source < tally.sources.size());
    const double start = how.start;
    std::vector<double> sent_on;
    sent_on.reserve(hits.size());
    double whole = 0;
    for (const FirstHit& hit : hits) {
        sent_on.push_back(surface(hit.group, hit.is_adaxial).scattered());
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
    Ledger ledger(counted_, how.source, how.is_beam, tally, leaf_sums);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const double energy =
            hits[i].energy *
            (hits[i].is_direct ? how.scale : how.scale_by_soil);
        sent_on[i] *= energy;
        ledger.arrive(hits[i], energy, sent_on[i]);
    }
    const double all = ledger.close().sent_on;
    if (!(all > 0)) return;
    IDEOTYPE_EXPECT(how.path_energy > 0);
    const double count = std::max(1., std::ceil(all / how.path_energy - 1e-9));
    const double energy = all / count;
    // Ensures that rounding does not lose the last path.
    std::size_t last = hits.size() - 1;
    while (sent_on[last] == 0) --last;
    double passed = 0, path = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        passed += sent_on[i];
        for (; path < count && ((start + path) * energy < passed || i == last);
             ++path)
            paths.push_back(
                {hits.at(i), hits[i].is_adaxial, how.source, energy, energy});
    }
}

void Tracer::follow(std::vector<ScatteredPath>& paths,
                    const Randomness& randomness, std::uint32_t net,
                    Tally& tally, LeafSums& leaf_sums) const {
    const auto sources = static_cast<std::uint32_t>(tally.sources.size());
    std::vector<Ledger> ledgers;
    for (std::uint32_t s = 0; s < sources; ++s)
        ledgers.emplace_back(counted_, s, false, tally, leaf_sums);
    std::vector<ScatteredPath> next;
    for (; !paths.empty(); net += sources) {
        PathSampler numbers(randomness.seed, randomness.generation,
                            randomness.first_randomisation, net);
        next.clear();
        std::uint32_t place = 0;
        for (const std::uint32_t i : order_by_place(
                 scene_, mapped(paths, [](const ScatteredPath& path) {
                     return path.hit.position;
                 }))) {
            ScatteredPath& path = paths[i];
            numbers.begin(place++);
            go_on(path, numbers, ledgers[path.source]);
            if (path.energy > 0) next.push_back(path);
        }
        tally.next_rays += paths.size();
        paths.swap(next);
    }
    IDEOTYPE_ENSURE(paths.empty());
    for (Ledger& ledger : ledgers) ledger.close();
}

void Tracer::go_on(ScatteredPath& path, PathSampler& numbers,
                   Ledger& ledger) const {
    const Lambertian& from = surface(path.hit.group, path.is_adaxial);
    const bool is_reflected =
        from.transmittance == 0 ||
        numbers.next() * from.scattered() < from.reflectance;
    const glm::dvec3 n =
        path.is_adaxial == is_reflected ? path.hit.normal : -path.hit.normal;
    const double u = numbers.next();
    const glm::dvec3 direction = lambertian(n, u, numbers.next());
    path.hit = travel(scene_, scene_.offset_origin(path.hit.position, n),
                      direction, poses_[path.source]);
    path.is_adaxial = glm::dot(direction, path.hit.normal) < 0;
    const double scattered =
        surface(path.hit.group, path.is_adaxial).scattered();
    ledger.keep(path.hit, path.is_adaxial,
                scattered > 0
                    ? absorb_and_continue(path, scattered, numbers.next())
                    : std::exchange(path.energy, 0.0));
}

}  // namespace ideotype
