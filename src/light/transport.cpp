// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/transport.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "beams/beam_costs.hpp"
#include "beams/directions.hpp"
#include "beams/first_hits.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/sampler.hpp"
#include "paths/launch.hpp"
#include "paths/tracer.hpp"
#include "resolution_of.hpp"

namespace ideotype {

namespace {

//! Finds the first hits of one source.
struct SourceRun {
    //! A function of a randomisation's first hits and a number uniform in [0,
    //! 1).
    using Use = std::function<void(std::size_t, const FirstHits&, double)>;

    const RayScene& scene;
    const Source& source;
    std::uint32_t number;
    const Launcher& launcher;
    const Randomness& randomness;

    //! Calls `use` for each randomisation from `first` up to `last`.
    //! @param all number of randomisations
    void find(std::uint32_t first_hits, int all, std::size_t first,
              std::size_t last, const Use& use) const {
        if (is_drawn(scene, source, first_hits, all))
            return draw(first_hits, all, first, last, use);
        const double energy = source.energy * launcher.entering() / first_hits;
        for (std::size_t r = first; r < last; ++r) {
            PathSampler numbers = sampler(r);
            const FirstHits hits(scene, launcher, numbers, first_hits, energy);
            use(r, hits, start(numbers));
        }
    }

    PathSampler sampler(std::size_t r) const {
        return {randomness.seed, randomness.generation,
                randomness.first_randomisation + static_cast<std::uint32_t>(r),
                number};
    }

    //! Returns a random number in a dimension that first hits do not use.
    double start(PathSampler& numbers) const {
        numbers.begin(0, scene.boundary() == Boundary::periodic ? 4 : 8);
        return numbers.next();
    }

    //! Draws the beam for few randomisations at a time, to limit memory.
    void draw(std::uint32_t first_hits, int all, std::size_t first,
              std::size_t last, const Use& use) const {
        const glm::dvec3 direction = not_level(*source.direction);
        const BeamLattice lattice =
            lattice_of(scene, direction, first_hits, all);
        const double energy =
            source.energy / static_cast<double>(lattice.points());
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
            const DepthBuffer buffer(scene, direction, lattice, shifts,
                                     source.pose);
            for (std::size_t i = 0; i < numbers.size(); ++i, ++r)
                use(r, {scene, buffer, i, energy}, start(numbers[i]));
        }
    }
};

//! The number of nets of scattered light that are reserved for each band.
constexpr std::uint32_t nets_of_band = 1u << 26;

//! Follows the light of one band on its way from surface to surface.
struct BandRun {
    BandRun(const Counted& counted, const Subject& subject, std::size_t number,
            const Workload& work, const std::vector<Launcher>& launchers,
            double brightest_soil)
        : band(subject.bands[number]),
          first_net(static_cast<std::uint32_t>(number) * nets_of_band),
          tracer(counted, band.optics, band.light.light.sources),
          has_leaf_light((number == 0 || band.is_by_piece) &&
                         counted.pieces > 0) {
        const std::vector<Source>& sources = band.light.light.sources;
        for (std::size_t s = 0; s < sources.size(); ++s) {
            const double all = sources[s].energy * launchers[s].entering();
            of_hit.push_back(all / std::max(1u, work.first_hits[s]));
            const bool is_told = number < work.path_energy.size() &&
                                 !work.path_energy[number].empty();
            of_path.push_back(
                (is_told ? work.path_energy[number][s] : of_hit[s]) /
                band.path_share);
            if (work.first_hits[s] > 0)
                most_paths += band.optics.most_scattered() * all / of_path[s];
            scale.push_back(sources[s].energy /
                            subject.light().sources[s].energy);
        }
        if (brightest_soil > 0)
            from_soil = band.optics.soil_albedo / brightest_soil;
    }

    const Band& band;
    std::uint32_t first_net;
    Tracer tracer;
    bool has_leaf_light;
    std::vector<double> of_hit, of_path;  //!< energies by source [J m-2]
    std::vector<double> scale;            //!< energy over that of first hits
    double from_soil = 1;   //!< scale for light that soil sends into a plot
    double most_paths = 0;  //!< most paths of a randomisation
    LeafSums leaf_sums{};
};

//! Returns whether the light of each source is the sum of its parts, to
//! rounding.
bool is_balanced(const Tally& tally) {
    return std::all_of(tally.sources.begin(), tally.sources.end(),
                       [](const Budget& budget) {
                           return std::abs(budget.total() - budget.incident) <=
                                  1e-9 * budget.incident;
                       });
}

}  // namespace

BandTallies simulate(const Subject& subject, const Workload& work,
                     int randomisations, const Randomness& randomness) {
    const RayScene& scene = subject.scene;
    const std::vector<Source>& sources = subject.light().sources;
    const Counted counted{scene, subject.groups, subject.layers,
                          subject.pieces};
    IDEOTYPE_EXPECT(randomisations > 0 && subject.layers.count > 0);
    IDEOTYPE_EXPECT(work.first_hits.size() == sources.size());
    for (const Band& band : subject.bands)
        IDEOTYPE_EXPECT(band.light.light.sources.size() == sources.size());
    double brightest_soil = 0;
    for (const Band& band : subject.bands)
        brightest_soil = std::max(brightest_soil, band.optics.soil_albedo);
    std::vector<Launcher> launchers;
    for (const Source& source : sources)
        launchers.emplace_back(scene, source, brightest_soil);
    std::vector<BandRun> bands;
    double most_paths = 0;
    for (std::size_t b = 0; b < subject.bands.size(); ++b) {
        bands.emplace_back(counted, subject, b, work, launchers,
                           brightest_soil);
        most_paths += bands.back().most_paths;
    }
    BandTallies tallies;
    for (const BandRun& band : bands) {
        Tally empty{std::vector<Budget>(sources.size()),
                    std::vector<double>(subject.groups.size()),
                    std::vector<double>(subject.layers.count)};
        if (band.has_leaf_light) empty.leaf_light.resize(sources.size());
        if (counted.parts.count() > 0)
            empty.parts.assign(sources.size(),
                               std::vector<double>(counted.parts.count()));
        tallies.emplace_back(static_cast<std::size_t>(randomisations), empty);
    }
    if (sources.empty()) return tallies;
    // The number of randomisations simulated together limits memory.
    constexpr std::size_t room = 1 << 18;
    const auto all = static_cast<std::size_t>(randomisations);
    const auto together = static_cast<std::size_t>(
        std::max(1., static_cast<double>(room) / (1 + most_paths)));
    for (std::size_t first = 0; first < all; first += together) {
        const std::size_t last = std::min(first + together, all);
        // Paths are kept by band and randomisation.
        std::vector paths(bands.size(), std::vector<std::vector<ScatteredPath>>(
                                            last - first));
        const auto follow = [&](std::size_t b, std::size_t r,
                                std::uint32_t source) {
            Randomness numbers = randomness;
            numbers.first_randomisation += static_cast<std::uint32_t>(r);
            bands[b].tracer.follow(
                paths[b][r - first], numbers,
                bands[b].first_net +
                    static_cast<std::uint32_t>(sources.size()) + source,
                tallies[b][r], bands[b].leaf_sums);
        };
        for (std::uint32_t s = 0; s < sources.size(); ++s) {
            const std::uint32_t hits = work.first_hits[s];
            if (hits == 0) continue;
            const bool is_beam = sources[s].direction.has_value();
            const auto use = [&](std::size_t r, const FirstHits& found,
                                 double start) {
                if (!found.are_drawn()) tallies.front()[r].rays += hits;
                for (std::size_t b = 0; b < bands.size(); ++b) {
                    BandRun& band = bands[b];
                    std::vector<ScatteredPath>& on = paths[b][r - first];
                    band.tracer.arrive(
                        found,
                        {s, is_beam, start, band.of_path[s], band.scale[s],
                         band.scale[s] * band.from_soil},
                        tallies[b][r], on, band.leaf_sums);
                    if (on.size() > room) follow(b, r, s);
                }
            };
            SourceRun{scene, sources[s], s, launchers[s], randomness}.find(
                hits, randomisations, first, last, use);
        }
        const auto last_source = static_cast<std::uint32_t>(sources.size() - 1);
        for (std::size_t b = 0; b < bands.size(); ++b)
            for (std::size_t r = first; r < last; ++r)
                follow(b, r, last_source);
    }
    for (std::size_t b = 0; b < bands.size(); ++b) {
        std::vector<double> largest = bands[b].of_hit;
        for (std::size_t s = 0; s < sources.size(); ++s)
            for (const Tally& tally : tallies[b])
                largest[s] = std::max(
                    largest[s],
                    std::min(bands[b].of_path[s], tally.sources[s].sent_on));
        const auto resolution = std::make_shared<const Resolution>(
            resolution_of(scene, subject.groups, bands[b].band.optics,
                          subject.layers, std::move(largest)));
        for (Tally& tally : tallies[b]) {
            tally.resolution = resolution;
            IDEOTYPE_ENSURE(is_balanced(tally));
        }
    }
    return tallies;
}

BandTallies simulate(const Subject& subject, const Accuracy& accuracy,
                     const Randomness& randomness) {
    const std::vector<Source>& sources = subject.light().sources;
    const auto paths = static_cast<std::uint32_t>(accuracy.paths);
    if (accuracy.paths < 1 || paths < sources.size())
        throw Error(fmt::format(
            "{} paths are too few for {} sources of light (a sun at each time "
            "step and the sky, a clear one at each); take more paths or a "
            "longer step",
            paths, sources.size()));
    Workload work;
    if (!sources.empty()) work.first_hits = share_paths(subject.light(), paths);
    return simulate(subject, work, accuracy.randomisations, randomness);
}

}  // namespace ideotype
