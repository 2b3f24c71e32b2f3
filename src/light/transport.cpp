#include "ideotype/light/transport.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "beam_costs.hpp"
#include "directions.hpp"
#include "first_hits.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/sampler.hpp"
#include "launch.hpp"
#include "resolution_of.hpp"
#include "travel.hpp"

namespace ideotype {

namespace {

//! Dimensions of a sampler that first hits use at most; scattered light has
//! the others.
std::size_t dimensions_of_first_hits(Boundary boundary) {
    return boundary == Boundary::periodic ? 4 : 8;
}

//! Adds up a budget of many small parts in two steps, so that their rounding
//! does not add up.
class Sum {
  public:
    explicit Sum(Budget& budget) : budget_(budget) {}

    Budget& next() {
        constexpr int step = 256;
        if (++count_ % step == 0) close();
        return part_;
    }
    void close() {
        budget_ += part_;
        part_ = {};
    }

  private:
    Budget& budget_;
    Budget part_;
    int count_ = 0;
};

//! Counts where light goes from its first hits on.
class Tracer {
  public:
    Tracer(const Scene& scene, const std::vector<Group>& groups,
           const Optics& optics, const Layers& layers)
        : scene_(scene), groups_(groups), optics_(optics), layers_(layers) {}

    //! Surfaces keep exactly their absorptance of what they meet first. What
    //! they send on is followed in as many paths of equal energy as make each
    //! at most `path_energy`, at least one. They start at hits that are evenly
    //! spread over all the energy that is sent on, in the order of the hits.
    //! Where all hits together send on less than one brings, that is not worth
    //! a path: instead all or nothing of a hit is sent on, with the right odds.
    void trace(const FirstHits& hits, PathSampler& sampler, double path_energy,
               std::uint32_t source, bool is_beam, Tally& tally) const {
        Parts parts{tally, nullptr, {}};
        if (!tally.leaf_light.empty()) {
            parts.leaf_light = &tally.leaf_light[source];
            parts.leaf_light->diffuse.resize(groups_.size());
            if (is_beam) parts.beam.resize(scene_.surfaces().normals.size());
        }
        trace(hits, sampler, path_energy, tally.sources[source], parts);
        for (std::uint32_t t = 0; t < parts.beam.size(); ++t)
            if (parts.beam[t] > 0)
                parts.leaf_light->beam.push_back({t, parts.beam[t]});
    }

  private:
    //! Where absorbed light is counted besides the budget.
    struct Parts {
        Tally& tally;
        LeafLight* leaf_light;
        std::vector<double> beam;  //!< of its triangles
    };

    void trace(const FirstHits& hits, PathSampler& sampler, double path_energy,
               Budget& budget, Parts& parts) const {
        const std::size_t first = dimensions_of_first_hits(scene_.boundary());
        sampler.begin(0, first);
        const double start = sampler.next();
        double whole = 0;
        for (const FirstHit& hit : hits) whole += scattered(hit);
        Sum sum(budget);
        if (whole < 1) {
            double passed = 0;
            for (std::size_t i = 0; i < hits.size(); ++i) {
                passed += scattered(hits[i]);
                const bool is_sent_on = passed > start;
                if (is_sent_on) passed -= 1;
                absorb(hits[i], is_sent_on ? 1 : 0, sum.next(), parts);
                if (is_sent_on && hits[i].energy > 0)
                    follow_from(hits, i, hits[i].energy, 0, sampler, sum.next(),
                                parts);
            }
            sum.close();
            return;
        }
        for (const FirstHit& hit : hits)
            absorb(hit, scattered(hit), sum.next(), parts);
        sum.close();
        if (!(budget.sent_on > 0)) return;
        const auto paths = static_cast<std::uint32_t>(
            std::max(1., std::ceil(budget.sent_on / path_energy - 1e-9)));
        const double energy = budget.sent_on / paths;
        double passed = 0;
        std::uint32_t path = 0;
        for (std::size_t i = 0; i < hits.size() && path < paths; ++i) {
            passed += hits[i].energy * scattered(hits[i]);
            // Rounding must not lose the last one.
            const bool is_last = i + 1 == hits.size();
            for (;
                 path < paths && ((start + path) * energy < passed || is_last);
                 ++path)
                follow_from(hits, i, energy, path, sampler, sum.next(), parts);
        }
        sum.close();
    }

    static bool against(const glm::dvec3& d, const glm::dvec3& n) {
        return glm::dot(d, n) < 0;
    }

    //! The part that is scattered where light meets something.
    double scattered(const FirstHit& hit) const {
        if (hit.group == FirstHit::sky) return 0;
        if (hit.group == FirstHit::soil) return optics_.soil_albedo;
        return optics_.of(groups_[hit.group].tissue).scattered();
    }

    //! Counts what a surface keeps of a first hit, and the part it sends on.
    void absorb(const FirstHit& hit, double part, Budget& budget,
                Parts& parts) const {
        budget.incident += hit.energy;
        const double sent_on = hit.energy * part;
        budget.sent_on += sent_on;
        const double kept = hit.energy - sent_on;
        if (hit.group == FirstHit::sky)
            budget.reflected += kept;
        else if (hit.group == FirstHit::soil)
            budget.soil += kept;
        else
            keep(hit.group, kept, hit.height, hit.is_adaxial, &hit, budget,
                 parts);
    }

    //! Counts what a face absorbs, of a first hit or later.
    void keep(std::uint32_t group, double energy, double height,
              bool is_adaxial, const FirstHit* first, Budget& budget,
              Parts& parts) const {
        Tally& tally = parts.tally;
        tally.groups[group] += energy;
        if (groups_[group].tissue != Tissue::leaf) {
            budget.stalks += energy;
            return;
        }
        const bool is_direct = first && first->is_direct;
        budget.leaves += energy;
        if (is_direct) budget.unscattered += energy;
        tally.layers[layers_.at(height)] += energy;
        (is_adaxial ? tally.adaxial : tally.abaxial) += energy;
        if (!parts.leaf_light) return;
        if (is_direct && !parts.beam.empty())
            parts.beam[first->triangle] += energy;
        else
            parts.leaf_light->diffuse[group] += energy;
    }

    //! Follows what a hit sends on.
    void follow_from(const FirstHits& hits, std::size_t hit, double energy,
                     std::uint32_t path, PathSampler& sampler, Budget& budget,
                     Parts& parts) const {
        sampler.begin(path, dimensions_of_first_hits(scene_.boundary()) + 1);
        PhotonPacket packet;
        packet.energy = energy;
        packet.is_scattered = true;
        set_out(packet, hits[hit], hits.at(hit), sampler);
        follow(packet, sampler, budget, parts);
    }

    //! The first direction of a path that starts at a hit.
    void set_out(PhotonPacket& packet, const FirstHit& hit, const Hit& point,
                 PathSampler& sampler) const {
        const double choice = sampler.next();
        const double u = sampler.next();
        const double v = sampler.next();
        if (hit.group == FirstHit::soil) {
            packet.position = scene_.wrapped(point.position);
            packet.direction = lambertian({0, 0, 1}, u, v);
        } else {
            const Lambertian& face = optics_.of(groups_[hit.group].tissue);
            scatter(packet, point, hit.is_adaxial,
                    choice * face.scattered() < face.reflectance, u, v);
        }
    }

    //! Until surfaces have absorbed the packet or it has left upwards.
    void follow(PhotonPacket& packet, PathSampler& sampler, Budget& budget,
                Parts& parts) const {
        const double started = packet.energy;
        Hit hit;
        while (packet.energy > 0) {
            ++parts.tally.next_rays;
            const Met met = travel(scene_, packet, hit);
            if (met == Met::sky) {
                budget.reflected += packet.energy;
                return;
            }
            if (met == Met::soil) {
                budget.soil += meet_soil(packet, started, sampler);
            } else {
                const bool is_adaxial = against(packet.direction, hit.normal);
                const double kept = meet_face(packet, hit, started, sampler);
                keep(hit.group, kept, hit.position.z, is_adaxial, nullptr,
                     budget, parts);
            }
        }
    }

    //! What a surface keeps of a packet; the packet goes on with the rest.
    //! While the scattered part is a large share of what the path started
    //! with, the surface keeps exactly its absorptance. A small scattered
    //! part is not worth following: instead all or nothing is scattered, with
    //! the right odds. Both rules are unbiased and lose no energy. `choice`
    //! is uniform in [0, 1) and is so again afterwards, for the next choice.
    double absorb_and_continue(PhotonPacket& packet, double started,
                               double scattered, double& choice) const {
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

    double meet_soil(PhotonPacket& packet, double started,
                     PathSampler& sampler) const {
        if (optics_.soil_albedo == 0) return std::exchange(packet.energy, 0.0);
        double choice = sampler.next();
        const double kept =
            absorb_and_continue(packet, started, optics_.soil_albedo, choice);
        if (packet.energy > 0) {
            const double u = sampler.next();
            const double v = sampler.next();
            packet.position = scene_.wrapped(packet.position);
            packet.direction = lambertian({0, 0, 1}, u, v);
        }
        return kept;
    }

    double meet_face(PhotonPacket& packet, const Hit& hit, double started,
                     PathSampler& sampler) const {
        const Lambertian& face = optics_.of(groups_[hit.group].tissue);
        const double scattered = face.scattered();
        if (scattered == 0) return std::exchange(packet.energy, 0.0);
        double choice = sampler.next();
        const double kept =
            absorb_and_continue(packet, started, scattered, choice);
        if (packet.energy > 0) {
            const double u = sampler.next();
            const double v = sampler.next();
            scatter(packet, hit, against(packet.direction, hit.normal),
                    choice * scattered < face.reflectance, u, v);
        }
        return kept;
    }

    void scatter(PhotonPacket& packet, const Hit& hit, bool is_front,
                 bool is_reflected, double u, double v) const {
        const glm::dvec3 n =
            is_front == is_reflected ? hit.normal : -hit.normal;
        packet.position = scene_.offset_origin(hit.position, n);
        packet.direction = lambertian(n, u, v);
    }

    const Scene& scene_;
    const std::vector<Group>& groups_;
    const Optics& optics_;
    const Layers& layers_;
};

//! The simulation of one source in all randomisations.
class SourceRun {
  public:
    SourceRun(const Scene& scene, const Source& source, std::uint32_t number,
              const Launcher& launcher, const Randomness& randomness)
        : scene_(scene),
          source_(source),
          number_(number),
          launcher_(launcher),
          randomness_(randomness) {}

    void trace(const Tracer& tracer, std::uint32_t first_hits,
               double path_energy, std::vector<Tally>& tallies) const {
        const int count = static_cast<int>(tallies.size());
        if (is_drawn(scene_, source_, first_hits, count))
            return draw(tracer, first_hits, path_energy, tallies);
        const double energy =
            source_.energy * launcher_.entering() / first_hits;
        for (std::size_t r = 0; r < tallies.size(); ++r) {
            PathSampler numbers = sampler(r);
            const FirstHits hits(scene_, launcher_, numbers, first_hits,
                                 energy);
            tallies[r].rays += first_hits;
            tracer.trace(hits, numbers, path_energy, number_,
                         source_.direction.has_value(), tallies[r]);
        }
    }

  private:
    PathSampler sampler(std::size_t r) const {
        return {randomness_.seed, randomness_.generation,
                randomness_.first_randomisation + static_cast<std::uint32_t>(r),
                number_};
    }

    //! So many replicates at a time as memory is reasonable for.
    void draw(const Tracer& tracer, std::uint32_t first_hits,
              double path_energy, std::vector<Tally>& tallies) const {
        const glm::dvec3 direction = not_level(*source_.direction);
        const BeamLattice lattice = lattice_of(
            scene_, direction, first_hits, static_cast<int>(tallies.size()));
        const double energy =
            source_.energy / static_cast<double>(lattice.points());
        const std::size_t together = replicates_together(lattice);
        for (std::size_t r = 0; r < tallies.size();) {
            std::vector<PathSampler> numbers;
            std::vector<glm::dvec2> shifts;
            while (numbers.size() < together &&
                   r + numbers.size() < tallies.size()) {
                numbers.push_back(sampler(r + numbers.size()));
                numbers.back().begin(0);
                const double u = numbers.back().next();
                shifts.push_back({u, numbers.back().next()});
            }
            const DepthBuffer buffer(scene_, direction, lattice, shifts);
            for (std::size_t i = 0; i < numbers.size(); ++i, ++r)
                tracer.trace(FirstHits(scene_, buffer, i, energy), numbers[i],
                             path_energy, number_, true, tallies[r]);
        }
    }

    const Scene& scene_;
    const Source& source_;
    std::uint32_t number_;
    const Launcher& launcher_;
    const Randomness& randomness_;
};

//! The largest part of light that anything scatters.
double most_scattered(const Optics& optics) {
    return std::max({optics.leaf.scattered(), optics.stalk.scattered(),
                     optics.sheath.scattered(), optics.soil_albedo});
}

}  // namespace

std::vector<std::uint32_t> share_paths(const Illumination& illumination,
                                       std::uint32_t paths) {
    const std::vector<Source>& sources = illumination.sources;
    double total = 0;
    for (const Source& source : sources) total += source.energy * source.effort;
    std::vector<std::uint32_t> counts;
    std::vector<double> remainders;
    std::uint32_t given = 0;
    for (const Source& source : sources) {
        const double exact = source.energy * source.effort / total *
                             static_cast<double>(paths - sources.size());
        counts.push_back(1 + static_cast<std::uint32_t>(exact));
        remainders.push_back(exact - std::floor(exact));
        given += counts.back();
    }
    std::vector<std::size_t> order(sources.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) {
                         return remainders[a] > remainders[b];
                     });
    for (std::size_t i = 0; given < paths; ++i, ++given)
        ++counts[order[i % order.size()]];
    return counts;
}

std::vector<Tally> simulate(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Workload& work, int randomisations,
    const Randomness& randomness, const Layers& layers, Detail detail) {
    const std::vector<Source>& sources = illumination.sources;
    std::vector<Tally> tallies(static_cast<std::size_t>(randomisations),
                               {std::vector<Budget>(sources.size()),
                                std::vector<double>(groups.size()),
                                std::vector<double>(layers.count)});
    if (detail == Detail::leaf_light)
        for (Tally& tally : tallies) tally.leaf_light.resize(sources.size());
    if (sources.empty()) return tallies;
    const Tracer tracer(scene, groups, optics, layers);
    std::vector<double> largest;
    for (std::uint32_t s = 0; s < sources.size(); ++s) {
        const Launcher launcher(scene, sources[s], optics.soil_albedo);
        const std::uint32_t hits = work.first_hits[s];
        const double of_hit =
            sources[s].energy * launcher.entering() / std::max(1u, hits);
        const double of_path =
            work.path_energy.empty() ? of_hit : work.path_energy[s];
        largest.push_back(std::max(
            of_hit,
            std::min(of_path, most_scattered(optics) * sources[s].energy *
                                  launcher.entering())));
        if (hits > 0)
            SourceRun(scene, sources[s], s, launcher, randomness)
                .trace(tracer, hits, of_path, tallies);
    }
    const auto resolution = std::make_shared<const Resolution>(
        resolution_of(scene, groups, optics, layers, largest));
    for (Tally& tally : tallies) tally.resolution = resolution;
    return tallies;
}

std::vector<Tally> simulate(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Accuracy& accuracy,
    const Randomness& randomness, const Layers& layers, Detail detail) {
    const std::vector<Source>& sources = illumination.sources;
    const auto paths = static_cast<std::uint32_t>(accuracy.paths);
    if (accuracy.paths < 1 || paths < sources.size())
        throw Error(fmt::format(
            "{} paths are too few for {} sources of light (a sun at each time "
            "step and the sky, a clear one at each); take more paths or a "
            "longer step",
            paths, sources.size()));
    Workload work;
    if (!sources.empty()) work.first_hits = share_paths(illumination, paths);
    return simulate(scene, groups, optics, illumination, work,
                    accuracy.randomisations, randomness, layers, detail);
}

}  // namespace ideotype
