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

//! Computes the first hits of one source.
struct SourceRun {
    //! Receives the index and the first hits of a randomisation, and a number
    //! uniform in [0, 1).
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

    //! Rasterises the beam for a few randomisations at a time, to limit memory.
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

//! The number of nets reserved for the scattered light of each band.
constexpr std::uint32_t nets_of_band = 1u << 26;

//! Traces the light of one band from surface to surface.
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
    //! Energies of a first hit and of a path, by source [J m-2].
    std::vector<double> of_hit, of_path;
    std::vector<double> scale;  //!< energy in the band relative to first hits
    double from_soil = 1;       //!< factor for light from soil into a plot
    double most_paths = 0;      //!< largest number of paths in a randomisation
    LeafSums leaf_sums{};
};

//! Returns whether the light of each source equals the sum of its parts, to
//! rounding.
bool is_balanced(const Tally& tally) {
    return std::all_of(tally.sources.begin(), tally.sources.end(),
                       [](const Budget& budget) {
                           return std::abs(budget.total() - budget.incident) <=
                                  1e-9 * budget.incident;
                       });
}

double brightest_soil_of(const Subject& subject) {
    double brightest = 0;
    for (const Band& band : subject.bands)
        brightest = std::max(brightest, band.optics.soil_albedo);
    return brightest;
}

std::vector<Launcher> launchers_of(const Subject& subject) {
    std::vector<Launcher> launchers;
    for (const Source& source : subject.light().sources)
        launchers.emplace_back(subject.scene, source,
                               brightest_soil_of(subject));
    return launchers;
}

//! Traces the light of all bands in all randomisations.
class Transport {
  public:
    Transport(const Subject& subject, const Workload& work, int randomisations,
              const Randomness& randomness)
        : subject_(subject),
          work_(work),
          all_(static_cast<std::size_t>(randomisations)),
          randomness_(randomness) {
        for (std::size_t b = 0; b < subject.bands.size(); ++b) {
            bands_.emplace_back(counted_, subject, b, work, launchers_,
                                brightest_soil_of(subject));
            tallies_.emplace_back(all_, empty_tally(bands_.back()));
        }
    }

    BandTallies run() && {
        if (sources_.empty()) return std::move(tallies_);
        // The number of randomisations simulated together is chosen to limit
        // memory.
        double most_paths = 0;
        for (const BandRun& band : bands_) most_paths += band.most_paths;
        const auto together = static_cast<std::size_t>(
            std::max(1., static_cast<double>(room) / (1 + most_paths)));
        for (std::size_t first = 0; first < all_; first += together)
            run(first, std::min(first + together, all_));
        for (std::size_t b = 0; b < bands_.size(); ++b) note_resolution(b);
        return std::move(tallies_);
    }

  private:
    //! The number of paths that are collected per band and randomisation before
    //! they are traced.
    static constexpr std::size_t room = 1 << 18;

    Tally empty_tally(const BandRun& band) const {
        Tally empty{std::vector<Budget>(sources_.size()),
                    std::vector<double>(subject_.groups.size()),
                    std::vector<double>(subject_.layers.count)};
        if (band.has_leaf_light) empty.leaf_light.resize(sources_.size());
        if (counted_.parts.count() > 0)
            empty.parts.assign(sources_.size(),
                               std::vector<double>(counted_.parts.count()));
        return empty;
    }

    //! Simulates some randomisations: first hits source by source, then the
    //! light that they scatter.
    void run(std::size_t first, std::size_t last) {
        first_ = first;
        paths_.assign(bands_.size(),
                      std::vector<std::vector<ScatteredPath>>(last - first));
        for (std::uint32_t s = 0; s < sources_.size(); ++s)
            if (work_.first_hits[s] > 0) find_hits(s, first, last);
        const auto last_source =
            static_cast<std::uint32_t>(sources_.size() - 1);
        for (std::size_t b = 0; b < bands_.size(); ++b)
            for (std::size_t r = first; r < last; ++r)
                follow(b, r, last_source);
    }

    void find_hits(std::uint32_t s, std::size_t first, std::size_t last) {
        const std::uint32_t hits = work_.first_hits[s];
        const bool is_beam = sources_[s].direction.has_value();
        const auto arrive = [&](std::size_t r, const FirstHits& found,
                                double start) {
            if (!found.are_drawn()) tallies_.front()[r].rays += hits;
            for (std::size_t b = 0; b < bands_.size(); ++b) {
                BandRun& band = bands_[b];
                std::vector<ScatteredPath>& paths = paths_[b][r - first_];
                band.tracer.arrive(
                    found,
                    {s, is_beam, start, band.of_path[s], band.scale[s],
                     band.scale[s] * band.from_soil},
                    tallies_[b][r], paths, band.leaf_sums);
                if (paths.size() > room) follow(b, r, s);
            }
        };
        SourceRun{subject_.scene, sources_[s], s, launchers_[s], randomness_}
            .find(hits, static_cast<int>(all_), first, last, arrive);
    }

    //! Traces the collected paths of a band and a randomisation to their ends.
    //! @param source index of the last source that contributed to the paths
    void follow(std::size_t b, std::size_t r, std::uint32_t source) {
        Randomness numbers = randomness_;
        numbers.first_randomisation += static_cast<std::uint32_t>(r);
        BandRun& band = bands_[b];
        band.tracer.follow(paths_[b][r - first_], numbers,
                           band.first_net +
                               static_cast<std::uint32_t>(sources_.size()) +
                               source,
                           tallies_[b][r], band.leaf_sums);
    }

    //! Computes the resolution from the largest energy that one path of each
    //! source carries, over all randomisations.
    void note_resolution(std::size_t b) {
        const BandRun& band = bands_[b];
        std::vector<double> largest = band.of_hit;
        for (std::size_t s = 0; s < sources_.size(); ++s)
            for (const Tally& tally : tallies_[b])
                largest[s] = std::max(
                    largest[s],
                    std::min(band.of_path[s], tally.sources[s].sent_on));
        const auto resolution = std::make_shared<const Resolution>(
            resolution_of(subject_.scene, subject_.groups, band.band.optics,
                          subject_.layers, std::move(largest)));
        for (Tally& tally : tallies_[b]) {
            tally.resolution = resolution;
            IDEOTYPE_ENSURE(is_balanced(tally));
        }
    }

    const Subject& subject_;
    const Workload& work_;
    std::size_t all_;  //!< number of randomisations
    const Randomness& randomness_;
    const std::vector<Source>& sources_ = subject_.light().sources;
    Counted counted_{subject_.scene, subject_.groups, subject_.layers,
                     subject_.pieces};
    std::vector<Launcher> launchers_ = launchers_of(subject_);
    std::vector<BandRun> bands_;
    BandTallies tallies_;
    //! First of the randomisations that are simulated together.
    std::size_t first_ = 0;
    //! Scattered paths [band][randomisation].
    std::vector<std::vector<std::vector<ScatteredPath>>> paths_;
};

}  // namespace

BandTallies simulate(const Subject& subject, const Workload& work,
                     int randomisations, const Randomness& randomness) {
    IDEOTYPE_EXPECT(randomisations > 0 && subject.layers.count > 0);
    IDEOTYPE_EXPECT(work.first_hits.size() == subject.light().sources.size());
    for (const Band& band : subject.bands)
        IDEOTYPE_EXPECT(band.light.light.sources.size() ==
                        subject.light().sources.size());
    return Transport(subject, work, randomisations, randomness).run();
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
