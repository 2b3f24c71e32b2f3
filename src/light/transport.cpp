#include "ideotype/light/transport.hpp"

#include <algorithm>
#include <functional>
#include <memory>

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
    //! What is done with those of a randomisation.
    using Use =
        std::function<void(std::size_t, const FirstHits&, PathSampler&)>;

    SourceRun(const Scene& scene, const Source& source, std::uint32_t number,
              const Launcher& launcher, const Randomness& randomness)
        : scene_(scene),
          source_(source),
          number_(number),
          launcher_(launcher),
          randomness_(randomness) {}

    void find(std::uint32_t first_hits, std::size_t randomisations,
              const Use& use) const {
        if (is_drawn(scene_, source_, first_hits,
                     static_cast<int>(randomisations)))
            return draw(first_hits, randomisations, use);
        const double energy =
            source_.energy * launcher_.entering() / first_hits;
        for (std::size_t r = 0; r < randomisations; ++r) {
            PathSampler numbers = sampler(r);
            use(r, {scene_, launcher_, numbers, first_hits, energy}, numbers);
        }
    }

  private:
    PathSampler sampler(std::size_t r) const {
        return {randomness_.seed, randomness_.generation,
                randomness_.first_randomisation + static_cast<std::uint32_t>(r),
                number_};
    }

    //! So many replicates at a time as memory is reasonable for.
    void draw(std::uint32_t first_hits, std::size_t randomisations,
              const Use& use) const {
        const glm::dvec3 direction = not_level(*source_.direction);
        const BeamLattice lattice = lattice_of(
            scene_, direction, first_hits, static_cast<int>(randomisations));
        const double energy =
            source_.energy / static_cast<double>(lattice.points());
        const std::size_t together = replicates_together(lattice);
        for (std::size_t r = 0; r < randomisations;) {
            std::vector<PathSampler> numbers;
            std::vector<glm::dvec2> shifts;
            while (numbers.size() < together &&
                   r + numbers.size() < randomisations) {
                numbers.push_back(sampler(r + numbers.size()));
                numbers.back().begin(0);
                const double u = numbers.back().next();
                shifts.push_back({u, numbers.back().next()});
            }
            const DepthBuffer buffer(scene_, direction, lattice, shifts);
            for (std::size_t i = 0; i < numbers.size(); ++i, ++r)
                use(r, {scene_, buffer, i, energy}, numbers[i]);
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
    const Tracer tracer(scene, groups, optics);
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
        if (hits == 0) continue;
        const bool is_beam = sources[s].direction.has_value();
        SourceRun(scene, sources[s], s, launcher, randomness)
            .find(hits, tallies.size(),
                  [&](std::size_t r, const FirstHits& found,
                      PathSampler& numbers) {
                      if (!found.are_drawn()) tallies[r].rays += hits;
                      Ledger ledger(counted, s, is_beam, tallies[r]);
                      tracer.trace(found, numbers, of_path, ledger);
                  });
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
