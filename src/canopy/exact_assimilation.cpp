// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/exact_assimilation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "ideotype/light/backward.hpp"
#include "ideotype/light/leaf_points.hpp"
#include "ideotype/light/sampler.hpp"

namespace ideotype {

namespace {

//! The number of diffuse-light samples at the lowest level.
constexpr std::size_t fewest_samples = 2;

//! The probability of each level relative to the next lower level.
const double next_level = std::pow(2., -1.5);

//! Sums of light by source.
using Sums = std::vector<double>;

class Referee {
  public:
    Referee(const Mesh& mesh, const LitLeaves& lit,
            const Randomness& randomness)
        : scene_(lit.scene),
          leaves_(mesh,
                  [&](std::uint32_t group) {
                      return mesh.groups[group].assimilates() &&
                             lit.leaves[group].photosynthesis;
                  }),
          backward_(lit.scene, mesh.groups, lit.par.optics,
                    lit.par.light.light.sources),
          light_(lit.par.light),
          layers_(lit.layers),
          randomness_(randomness),
          empty_{Sums(lit.leaves.size()), Sums(lit.layers.count),
                 Sums(light_.series.steps.size())} {
        for (const TimeStep& step : light_.series.steps)
            amount_.push_back(step.seconds * mol_per_umol / light_.series.days);
        for (std::size_t g = 0; g < lit.leaves.size(); ++g) {
            const LeafRates& rates = lit.leaves[g].rates;
            const Photosynthesis* photosynthesis = lit.leaves[g].photosynthesis;
            absorbed_.push_back(
                lit.par.optics.of(mesh.groups[g].material).most_absorbed() *
                lit.photons);
            for (const TimeStep& step : light_.series.steps)
                response_.push_back(
                    photosynthesis
                        ? response(rates, air_of(step, *photosynthesis))
                        : LeafResponse{});
        }
    }

    ExactAssimilation result(const Accuracy& accuracy) {
        IDEOTYPE_EXPECT(accuracy.paths > 0 && accuracy.randomisations > 0);
        const auto count = static_cast<std::size_t>(accuracy.randomisations);
        constexpr int first_points = 256;
        std::vector<FluxTally> sums(count, empty_);
        std::vector<RandomStream> random;
        for (std::size_t r = 0; r < count; ++r)
            random.emplace_back(randomness_.seed, Purpose::backward,
                                randomness_.generation, number(r));
        ExactAssimilation found;
        if (!(leaves_.area() > 0)) return {sums, 0, false};
        do {
            const int next =
                accuracy.tolerance > 0
                    ? std::min(accuracy.paths,
                               std::max(first_points, 2 * found.points))
                    : accuracy.paths;
            for (std::size_t r = 0; r < count; ++r)
                add(number(r), found.points, next, random[r], sums[r]);
            found.points = next;
            found.tallies = sums;
            const double weight = leaves_.area() / scene_.ground_area() / next;
            for (FluxTally& tally : found.tallies)
                for (Sums* part : {&tally.groups, &tally.layers, &tally.steps})
                    for (double& x : *part) x *= weight;
            found.is_capped =
                relative_error(found.tallies) > accuracy.tolerance;
        } while (accuracy.tolerance > 0 && found.is_capped &&
                 found.points < accuracy.paths);
        found.is_capped = found.is_capped && accuracy.tolerance > 0;
        return found;
    }

  private:
    static double relative_error(const std::vector<FluxTally>& all) {
        constexpr double unknown = std::numeric_limits<double>::infinity();
        if (all.size() < 2) return unknown;
        const Estimate found = estimate(mapped(all, &FluxTally::sum));
        if (found.standard_error == 0) return 0;
        return found.mean > 0 ? found.standard_error / found.mean : unknown;
    }

    std::uint32_t number(std::size_t randomisation) const {
        return randomness_.first_randomisation +
               static_cast<std::uint32_t>(randomisation);
    }

    //! Adds points of one randomisation: those from `first` up to, not
    //! including, `last`.
    void add(std::uint32_t number, int first, int last, RandomStream& random,
             FluxTally& tally) {
        PathSampler places(randomness_.seed, randomness_.generation, number, 0);
        for (int i = first; i < last; ++i) {
            places.begin(static_cast<std::uint32_t>(i));
            const double share = places.next();
            const double s = places.next();
            const LeafPoint point = leaves_.at(share, s, places.next());
            const double part = own_part(scene_, point);
            if (part > 0) add(point, part, random, tally);
        }
    }

    void add(const LeafPoint& point, double part, RandomStream& random,
             FluxTally& tally) {
        const std::vector<Source>& sources = light_.light.sources;
        beam_.assign(sources.size(), 0);
        for (std::size_t s = 0; s < sources.size(); ++s)
            if (sources[s].direction) beam_[s] = backward_.beam(point, s);
        rate_.assign(amount_.size(), 0);
        add_rates(point, mean(point, fewest_samples, random), 1);
        std::size_t samples = fewest_samples;
        double odds = 1 - next_level;
        for (; random.uniform() < next_level; samples *= 2) odds *= next_level;
        const Sums half = mean(point, samples, random);
        const Sums other = mean(point, samples, random);
        Sums both(half.size());
        for (std::size_t s = 0; s < both.size(); ++s)
            both[s] = (half[s] + other[s]) / 2;
        add_rates(point, both, 1 / odds);
        add_rates(point, half, -.5 / odds);
        add_rates(point, other, -.5 / odds);
        double sum = 0;
        for (std::size_t i = 0; i < rate_.size(); ++i) {
            tally.steps[i] += part * rate_[i];
            sum += part * rate_[i] * amount_[i];
        }
        tally.groups[point.group] += sum;
        tally.layers[layers_.at(scene_.placed(point.position).z)] += sum;
    }

    Sums mean(const LeafPoint& point, std::size_t samples,
              RandomStream& random) const {
        Sums light(light_.light.sources.size());
        for (std::size_t k = 0; k < samples; ++k)
            backward_.add_diffuse(point, random, light);
        for (double& x : light) x /= static_cast<double>(samples);
        return light;
    }

    //! Adds the response to diffuse light and the beam, multiplied by a weight.
    void add_rates(const LeafPoint& point, const Sums& diffuse, double weight) {
        for (std::size_t i = 0; i < rate_.size(); ++i) {
            const Irradiance& par = light_.series.steps[i].par;
            const auto of = [](int source, const Sums& light) {
                return source < 0 ? 0 : light[static_cast<std::size_t>(source)];
            };
            const int beam = light_.beam_of[i], sky = light_.sky_of[i];
            const double absorbed =
                absorbed_[point.group] *
                (par.beam * (of(beam, beam_) + of(beam, diffuse)) +
                 par.diffuse * of(sky, diffuse));
            if (!(absorbed > 0)) continue;
            double rate = 0;
            gross(response_[point.group * rate_.size() + i], {&absorbed, 1},
                  &rate);
            rate_[i] += weight * rate;
        }
    }

    const RayScene& scene_;
    LeafPoints leaves_;
    BackwardLight backward_;
    const SeriesIllumination& light_;
    Layers layers_;
    Randomness randomness_;
    //! Photons absorbed per unit of irradiance by the more absorbing face of
    //! each leaf group. Light at points is relative to this amount.
    std::vector<double> absorbed_;
    FluxTally empty_;
    std::vector<double> amount_;  //!< amount per rate, by step [mol s umol-1]
    std::vector<LeafResponse> response_;  //!< responses [group][step]

    // Sums over the beams at one point.
    Sums beam_;
    Sums rate_;  //!< rate by step [umol m-2 s-1]
};

}  // namespace

ExactAssimilation assimilate_exactly(const Mesh& mesh, const LitLeaves& lit,
                                     const Accuracy& accuracy,
                                     const Randomness& randomness) {
    IDEOTYPE_EXPECT(lit.leaves.size() == mesh.groups.size());
    return Referee(mesh, lit, randomness).result(accuracy);
}

}  // namespace ideotype
