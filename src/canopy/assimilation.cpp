// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/assimilation.hpp"

#include <map>
#include <numeric>
#include <utility>

#include "pair_light.hpp"

namespace ideotype {

namespace {

//! f at some places, with its derivatives.
struct Responses {
    std::vector<double> light, value, slope, curvature;

    void resize(std::size_t places) {
        for (auto* part : {&light, &value, &slope, &curvature})
            part->resize(places);
    }

    void respond(const LeafResponse& response, std::size_t first,
                 std::size_t last) {
        if (first < last)
            expand(response, {&light[first], last - first}, &value[first],
                   &slope[first], &curvature[first]);
    }

    Expansion at(std::size_t i) const {
        return {value[i], slope[i], curvature[i]};
    }
};

//! [f(D + b) - f(D)] / b with its derivatives in D.
Expansion gain(const Expansion& shaded, const Expansion& lit, double beam) {
    // The difference of less would be mostly rounding.
    constexpr double least = 0.01;
    if (beam < least)
        return {shaded.slope + beam / 2 * shaded.curvature, shaded.curvature,
                0};
    return {(lit.value - shaded.value) / beam,
            (lit.slope - shaded.slope) / beam,
            (lit.curvature - shaded.curvature) / beam};
}

class Assimilation {
  public:
    Assimilation(const std::vector<Tally>& tallies, const Pieces& pieces,
                 const LitLeaves& lit)
        : tallies_(tallies),
          lit_leaves_(lit),
          light_(lit.par.light),
          places_(pieces, lit, tallies.size() == 1),
          expectation_(places_, tallies),
          mean_(places_.count()),
          differences_(tallies.size(), std::vector<double>(places_.count())),
          all_(tallies.size(), {std::vector<double>(lit.leaves.size()),
                                std::vector<double>(lit.layers.count),
                                std::vector<double>(light_.series.steps.size()),
                                std::vector<double>(pieces.rows)}) {
        shaded_.resize(places_.count());
    }

    std::vector<AssimilationTally> result() {
        std::map<int, std::map<int, std::vector<std::size_t>>> steps;
        for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
            if (light_.beam_of[i] >= 0 || light_.sky_of[i] >= 0)
                steps[light_.sky_of[i]][light_.beam_of[i]].push_back(i);
        for (const auto& [of_sky, beams] : steps) {
            SkyLight sky(tallies_, of_sky, places_, expectation_);
            for (const auto& [beam, of_pair] : beams) add(beam, sky, of_pair);
            for (std::size_t r = 0; r < tallies_.size(); ++r)
                for (const auto& [v, x] : sky.light.parts[r])
                    differences_[r][places_.of[v]] +=
                        x * (sky.weight[v] + sky.weight_of_square[v] * x);
        }
        add_up();
        return std::move(all_);
    }

  private:
    //! Adds steps that share a sun and a sky.
    void add(int beam, SkyLight& sky, const std::vector<std::size_t>& steps) {
        PairLight pair(tallies_, lit_leaves_, places_, expectation_, beam, sky);
        std::vector<Moments> weights(places_.count());
        double whole = 0;
        for (const std::size_t i : steps)
            whole += add(i, beam, sky, pair, weights);
        if (tallies_.size() == 1 || whole == 0) return;
        const std::vector<double> sums = pair.scatter(weights, differences_);
        const double mean = std::accumulate(sums.begin(), sums.end(), 0.) /
                            static_cast<double>(sums.size());
        // The errors of its steps are taken as in proportion to them.
        for (std::size_t r = 0; r < sums.size(); ++r)
            for (const std::size_t i : steps)
                all_[r].steps[i] *= 1 + (sums[r] - mean) / whole;
    }

    //! Adds a step [mol m-2], and the weights of moments in it.
    double add(std::size_t i, int beam, const SkyLight& sky, PairLight& pair,
               std::vector<Moments>& weights) {
        const TimeStep& step = light_.series.steps[i];
        const auto scale = [&](int source, double irradiance) {
            if (source < 0) return 0.;
            return irradiance * lit_leaves_.photons /
                   light_.light.sources[static_cast<std::size_t>(source)]
                       .energy;
        };
        const double of_sun = scale(beam, step.par.beam);
        const double of_sky = scale(sky.source, step.par.diffuse);
        const auto on_leaf = [&](const PairLight::Bin& bin) {
            return places_.absorptance[bin.place] * step.par.beam *
                   lit_leaves_.photons * bin.cosine;
        };
        const double amount = step.seconds * mol_per_umol / light_.series.days;
        std::vector<PairLight::Bin>& bins = pair.bins();
        for (std::size_t p = 0; p < places_.count(); ++p)
            shaded_.light[p] =
                of_sun * pair.expected()[p] + of_sky * sky.expected[p];
        lit_.resize(bins.size());
        for (std::size_t b = 0; b < bins.size(); ++b)
            lit_.light[b] = shaded_.light[bins[b].place] + on_leaf(bins[b]);
        respond(step, bins);
        double whole = 0;
        const auto add = [&](const Expansion& at, double times,
                             const Moments& of, std::size_t place,
                             Moments& all) {
            const Moments weight{times * at.value,
                                 times * at.slope * of_sun,
                                 times * at.slope * of_sky,
                                 times * at.curvature * of_sun * of_sun / 2,
                                 times * at.curvature * of_sun * of_sky,
                                 times * at.curvature * of_sky * of_sky / 2};
            const double sum = weight.dot(of);
            mean_[place] += sum;
            whole += sum;
            all.add(weight, 1);
        };
        for (std::size_t p = 0; p < places_.count(); ++p)
            add(shaded_.at(p), amount, pair.moments()[p], p, weights[p]);
        for (std::size_t b = 0; b < bins.size(); ++b)
            add(gain(shaded_.at(bins[b].place), lit_.at(b), on_leaf(bins[b])),
                amount * of_sun, bins[b].moments, bins[b].place,
                bins[b].weights);
        for (AssimilationTally& tally : all_) tally.steps[i] = whole / amount;
        return whole;
    }

    //! Leaf by leaf.
    void respond(const TimeStep& step,
                 const std::vector<PairLight::Bin>& bins) {
        std::vector<LeafResponse> responses;
        for (const LeafGroup& leaf : lit_leaves_.leaves)
            responses.push_back(
                leaf.photosynthesis
                    ? response(leaf.rates, air_of(step, *leaf.photosynthesis))
                    : LeafResponse{});
        for (std::size_t first = 0, last = 0, b = 0; first < places_.count();
             first = last) {
            const std::uint32_t leaf = places_.group[first];
            while (last < places_.count() && places_.group[last] == leaf)
                ++last;
            shaded_.respond(responses[leaf], first, last);
            const std::size_t first_bin = b;
            while (b < bins.size() && bins[b].place < last) ++b;
            lit_.respond(responses[leaf], first_bin, b);
        }
    }

    //! Pseudo-values of places to those of leaves, layers and rows.
    void add_up() {
        for (std::size_t p = 0; p < places_.count(); ++p) {
            double mean = 0;
            for (const std::vector<double>& each : differences_)
                mean += each[p] / static_cast<double>(tallies_.size());
            for (std::size_t r = 0; r < tallies_.size(); ++r) {
                const double amount = mean_[p] + differences_[r][p] - mean;
                all_[r].groups[places_.group[p]] += amount;
                all_[r].layers[lit_leaves_.layers.at(places_.height[p])] +=
                    amount;
                if (!all_[r].rows.empty())
                    all_[r].rows[places_.row[p]] += amount;
            }
        }
    }

    const std::vector<Tally>& tallies_;
    const LitLeaves& lit_leaves_;
    const SeriesIllumination& light_;
    LeafPlaces places_;
    ExpectedLight expectation_;

    Responses shaded_;          //!< of places, in a step
    Responses lit_;             //!< of bins
    std::vector<double> mean_;  //!< of places [mol m-2]
    //! [randomisation][place], but for what all share
    std::vector<std::vector<double>> differences_;
    std::vector<AssimilationTally> all_;  //!< pseudo-values
};

}  // namespace

std::vector<AssimilationTally> assimilate(const std::vector<Tally>& tallies,
                                          const Pieces& pieces,
                                          const LitLeaves& lit) {
    return Assimilation(tallies, pieces, lit).result();
}

}  // namespace ideotype
