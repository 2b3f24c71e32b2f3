#include "ideotype/light/transport.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "directions.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/sampler.hpp"
#include "launch.hpp"
#include "resolution_of.hpp"
#include "travel.hpp"

namespace ideotype {

namespace {

//! Traces the paths of one randomisation into one tally.
class Tracer {
  public:
    Tracer(const Scene& scene, const std::vector<Group>& groups,
           const Optics& optics, const Layers& layers, PathSampler sampler)
        : scene_(scene),
          groups_(groups),
          optics_(optics),
          layers_(layers),
          sampler_(std::move(sampler)) {}

    void trace(std::uint32_t path, const Launcher& launcher, double energy,
               Budget& budget, Tally& tally) {
        sampler_.begin(path);
        PhotonPacket packet = launcher.launch(sampler_, energy);
        const double started = packet.energy;
        budget.incident += started;
        Hit hit;
        while (packet.energy > 0) {
            const Met met = travel(scene_, packet, hit);
            if (met == Met::sky) {
                budget.reflected += packet.energy;
                return;
            }
            if (met == Met::soil) {
                budget.soil += meet_soil(packet, started);
            } else {
                const bool is_adaxial = against(packet.direction, hit.normal);
                const Tissue tissue = groups_[hit.group].tissue;
                const double share = meet_face(packet, hit, started, tissue);
                tally.groups[hit.group] += share;
                if (tissue == Tissue::leaf) {
                    budget.leaves += share;
                    if (!packet.is_scattered) budget.unscattered += share;
                    tally.layers[layers_.at(hit.position.z)] += share;
                    (is_adaxial ? tally.adaxial : tally.abaxial) += share;
                } else {
                    budget.stalks += share;
                }
            }
            packet.is_scattered = true;
        }
    }

  private:
    static bool against(const glm::dvec3& d, const glm::dvec3& n) {
        return glm::dot(d, n) < 0;
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

    double meet_soil(PhotonPacket& packet, double started) {
        if (optics_.soil_albedo == 0) return std::exchange(packet.energy, 0.0);
        double choice = sampler_.next();
        const double kept =
            absorb_and_continue(packet, started, optics_.soil_albedo, choice);
        if (packet.energy > 0) {
            const double u = sampler_.next();
            const double v = sampler_.next();
            packet.position = scene_.wrapped(packet.position);
            packet.direction = lambertian({0, 0, 1}, u, v);
        }
        return kept;
    }

    double meet_face(PhotonPacket& packet, const Hit& hit, double started,
                     Tissue tissue) {
        const Lambertian& surface = optics_.of(tissue);
        const double scattered = surface.reflectance + surface.transmittance;
        if (scattered == 0) return std::exchange(packet.energy, 0.0);
        double choice = sampler_.next();
        const double kept =
            absorb_and_continue(packet, started, scattered, choice);
        if (packet.energy > 0) {
            const double u = sampler_.next();
            const double v = sampler_.next();
            const bool is_reflected = choice * scattered < surface.reflectance;
            scatter(packet, hit, is_reflected, u, v);
        }
        return kept;
    }

    void scatter(PhotonPacket& packet, const Hit& hit, bool is_reflected,
                 double u, double v) const {
        const bool is_front = against(packet.direction, hit.normal);
        const glm::dvec3 n =
            is_front == is_reflected ? hit.normal : -hit.normal;
        packet.position = scene_.offset_origin(hit.position, n);
        packet.direction = lambertian(n, u, v);
    }

    const Scene& scene_;
    const std::vector<Group>& groups_;
    const Optics& optics_;
    const Layers& layers_;
    PathSampler sampler_;
};

//! Splits paths among sources in proportion to energy and effort, at least one
//! each, by largest remainders.
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

}  // namespace

std::vector<Tally> simulate(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Accuracy& accuracy,
    const Randomness& randomness, const Layers& layers) {
    const std::vector<Source>& sources = illumination.sources;
    const auto paths = static_cast<std::uint32_t>(accuracy.paths);
    if (accuracy.paths < 1 || paths < sources.size())
        throw Error(fmt::format(
            "{} paths are too few for {} sources of light (a sun at each time "
            "step and the sky, a clear one at each); take more paths or a "
            "longer step",
            paths, sources.size()));
    std::vector<Tally> tallies(
        static_cast<std::size_t>(accuracy.randomisations),
        {std::vector<Budget>(sources.size()),
         std::vector<double>(groups.size()),
         std::vector<double>(layers.count)});
    if (sources.empty()) return tallies;

    std::vector<Launcher> launchers;
    for (const Source& source : sources)
        launchers.emplace_back(scene, source, optics.soil_albedo);
    const std::vector<std::uint32_t> counts = share_paths(illumination, paths);
    std::vector<double> path_energy;
    for (std::size_t s = 0; s < sources.size(); ++s)
        path_energy.push_back(sources[s].energy * launchers[s].entering() /
                              counts[s]);
    const auto resolution = std::make_shared<const Resolution>(
        resolution_of(scene, groups, optics, layers, path_energy));
    auto randomisation = randomness.first_randomisation;
    for (Tally& tally : tallies) {
        tally.resolution = resolution;
        for (std::uint32_t s = 0; s < sources.size(); ++s) {
            Tracer tracer(scene, groups, optics, layers,
                          PathSampler(randomness.seed, randomness.generation,
                                      randomisation, s));
            for (std::uint32_t p = 0; p < counts[s]; ++p)
                tracer.trace(p, launchers[s], path_energy[s], tally.sources[s],
                             tally);
        }
        ++randomisation;
    }
    return tallies;
}

}  // namespace ideotype
