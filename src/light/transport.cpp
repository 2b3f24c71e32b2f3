// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/transport.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "beam_costs.hpp"
#include "directions.hpp"
#include "first_hits.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/sampler.hpp"
#include "launch.hpp"
#include "resolution_of.hpp"
#include "tracer.hpp"

namespace ideotype {

namespace {

//! The first hits of one source.
class SourceRun {
  public:
    //! What is done with those of a randomisation; with a number that is
    //! uniform in [0, 1).
    using Use = std::function<void(std::size_t, const FirstHits&, double)>;

    SourceRun(const Scene& scene, const Source& source, std::uint32_t number,
              const Launcher& launcher, const Randomness& randomness)
        : scene_(scene),
          source_(source),
          number_(number),
          launcher_(launcher),
          randomness_(randomness) {}

    //! @param all randomisations, of which those from `first` up to `last`
    void find(std::uint32_t first_hits, int all, std::size_t first,
              std::size_t last, const Use& use) const {
        if (is_drawn(scene_, source_, first_hits, all))
            return draw(first_hits, all, first, last, use);
        const double energy =
            source_.energy * launcher_.entering() / first_hits;
        for (std::size_t r = first; r < last; ++r) {
            PathSampler numbers = sampler(r);
            const FirstHits hits(scene_, launcher_, numbers, first_hits,
                                 energy);
            use(r, hits, start(numbers));
        }
    }

  private:
    PathSampler sampler(std::size_t r) const {
        return {randomness_.seed, randomness_.generation,
                randomness_.first_randomisation + static_cast<std::uint32_t>(r),
                number_};
    }

    //! Beyond the dimensions that first hits use.
    double start(PathSampler& numbers) const {
        numbers.begin(0, scene_.boundary() == Boundary::periodic ? 4 : 8);
        return numbers.next();
    }

    //! So many replicates at a time as memory is reasonable for.
    void draw(std::uint32_t first_hits, int all, std::size_t first,
              std::size_t last, const Use& use) const {
        const glm::dvec3 direction = not_level(*source_.direction);
        const BeamLattice lattice =
            lattice_of(scene_, direction, first_hits, all);
        const double energy =
            source_.energy / static_cast<double>(lattice.points());
        const std::size_t together = replicates_together(lattice);
        for (std::size_t r = first; r < last;) {
            std::vector<PathSampler> numbers;
            std::vector<glm::dvec2> shifts;
            while (numbers.size() < together && r + numbers.size() < last) {
                numbers.push_back(sampler(r + numbers.size()));
                numbers.back().begin(0);
                const double u = numbers.back().next();
                shifts.push_back({u, numbers.back().next()});
            }
            const DepthBuffer buffer(scene_, direction, lattice, shifts);
            for (std::size_t i = 0; i < numbers.size(); ++i, ++r)
                use(r, {scene_, buffer, i, energy}, start(numbers[i]));
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
    const Counted counted{scene, groups, layers};
    const Tracer tracer(counted, optics);
    std::vector<Launcher> launchers;
    std::vector<double> of_path, of_hit;
    double most_paths = 0;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        launchers.emplace_back(scene, sources[s], optics.soil_albedo);
        const double all = sources[s].energy * launchers[s].entering();
        of_hit.push_back(all / std::max(1u, work.first_hits[s]));
        of_path.push_back(work.path_energy.empty() ? of_hit[s]
                                                   : work.path_energy[s]);
        if (work.first_hits[s] > 0)
            most_paths += most_scattered(optics) * all / of_path[s];
    }
    LeafSums leaf_sums;
    // So many randomisations at a time as memory is reasonable for.
    constexpr std::size_t room = 1 << 18;
    const auto together = static_cast<std::size_t>(
        std::max(1., static_cast<double>(room) / (1 + most_paths)));
    for (std::size_t first = 0; first < tallies.size(); first += together) {
        const std::size_t last = std::min(first + together, tallies.size());
        std::vector<std::vector<ScatteredPath>> paths(last - first);
        const auto follow = [&](std::size_t r, std::uint32_t source) {
            Randomness numbers = randomness;
            numbers.first_randomisation += static_cast<std::uint32_t>(r);
            tracer.follow(paths[r - first], numbers,
                          static_cast<std::uint32_t>(sources.size()) + source,
                          tallies[r], leaf_sums);
        };
        for (std::uint32_t s = 0; s < sources.size(); ++s) {
            const std::uint32_t hits = work.first_hits[s];
            if (hits == 0) continue;
            const bool is_beam = sources[s].direction.has_value();
            SourceRun(scene, sources[s], s, launchers[s], randomness)
                .find(hits, randomisations, first, last,
                      [&](std::size_t r, const FirstHits& found, double start) {
                          if (!found.are_drawn()) tallies[r].rays += hits;
                          tracer.arrive(found, s, is_beam, start, of_path[s],
                                        tallies[r], paths[r - first],
                                        leaf_sums);
                          if (paths[r - first].size() > room) follow(r, s);
                      });
        }
        const auto last_source = static_cast<std::uint32_t>(sources.size() - 1);
        for (std::size_t r = first; r < last; ++r) follow(r, last_source);
    }
    std::vector<double> largest = of_hit;
    for (std::size_t s = 0; s < sources.size(); ++s)
        for (const Tally& tally : tallies)
            largest[s] = std::max(
                largest[s], std::min(of_path[s], tally.sources[s].sent_on));
    const auto resolution = std::make_shared<const Resolution>(
        resolution_of(scene, groups, optics, layers, std::move(largest)));
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
