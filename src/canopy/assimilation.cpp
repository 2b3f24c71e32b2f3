// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/assimilation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "water/water_fluxes.hpp"

namespace ideotype {

namespace {

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
          differences_(tallies.size(), std::vector<double>(places_.count())) {
        FluxTally none{std::vector<double>(lit.leaves.size()),
                       std::vector<double>(lit.layers.count),
                       std::vector<double>(light_.series.steps.size()),
                       std::vector<double>(pieces.rows)};
        all_.assign(lit.air ? leaf_fluxes : 1, {tallies.size(), none});
        if (lit.air) water_.emplace(lit, places_, expectation_, all_);
    }

    FluxTallies result() {
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
        if (water_) add_nights();
        for (std::size_t k = 0; k < all_.size(); ++k) add_up(k);
        if (water_) water_->add_drawn_to(all_);
        return std::move(all_);
    }

  private:
    //! Adds steps that share a sun and a sky.
    void add(int beam, SkyLight& sky, const std::vector<std::size_t>& steps) {
        PairLight pair(tallies_, lit_leaves_, places_, expectation_, beam, sky);
        weights_.assign(places_.count(), {});
        whole_ = 0;
        if (water_) water_->meet(beam, sky.source);
        StepLight light{pair};
        light.shaded.resize(places_.count());
        light.lit.resize(pair.bins().size());
        light.beams.resize(pair.bins().size());
        for (const std::size_t i : steps) add(i, beam, sky, pair, light);
        if (tallies_.size() == 1 || whole_ == 0) return;
        const std::vector<double> sums = pair.scatter(weights_, differences_);
        const double mean = mean_of(sums);
        // The error of each step is assumed to be proportional to its value.
        for (std::vector<FluxTally>& flux : all_)
            for (std::size_t r = 0; r < sums.size(); ++r)
                for (const std::size_t i : steps)
                    flux[r].steps[i] *= 1 + (sums[r] - mean) / whole_;
    }

    //! Adds a step, and the weights of the moments in the step.
    void add(std::size_t i, int beam, const SkyLight& sky, PairLight& pair,
             StepLight& light) {
        const TimeStep& step = light_.series.steps[i];
        const auto scale = [&](int source, double irradiance) {
            if (source < 0) return 0.;
            return irradiance * lit_leaves_.photons /
                   light_.light.sources[static_cast<std::size_t>(source)]
                       .energy;
        };
        light.scales = {scale(beam, step.par.beam),
                        scale(sky.source, step.par.diffuse)};
        const auto [of_sun, of_sky] = light.scales;
        std::vector<PairLight::Bin>& bins = pair.bins();
        for (std::size_t p = 0; p < places_.count(); ++p)
            light.shaded.light[p] =
                of_sun * pair.expected()[p] + of_sky * sky.expected[p];
        for (std::size_t b = 0; b < bins.size(); ++b) {
            light.beams[b] = places_.absorptance[bins[b].place] *
                             step.par.beam * lit_leaves_.photons *
                             bins[b].cosine;
            light.lit.light[b] =
                light.shaded.light[bins[b].place] + light.beams[b];
        }
        respond(step, light);
        const double amount =
            amount_of(LeafFlux::gross, step) / light_.series.days;
        double whole = 0;
        light.of_places.assign(places_.count(), 0);
        const auto add = [&](const Expansion& at, double times,
                             const Moments& of, std::size_t place,
                             Moments& all) {
            const Moments weight = light.scales.weigh(at, times);
            const double sum = weight.dot(of);
            mean_[place] += sum;
            light.of_places[place] += sum;
            whole += sum;
            all.add(weight, 1);
        };
        for (std::size_t p = 0; p < places_.count(); ++p)
            add(light.shaded.at(p), amount, pair.moments()[p], p, weights_[p]);
        for (std::size_t b = 0; b < bins.size(); ++b)
            add(gain(light.shaded.at(bins[b].place), light.lit.at(b),
                     light.beams[b]),
                amount * of_sun, bins[b].moments, bins[b].place,
                bins[b].weights);
        whole_ += whole;
        if (water_) water_->add(i, light);
        take_steps(i, whole / amount);
    }

    //! Notes the fluxes of a step.
    //! @param gross assimilation at the temperature of the air
    void take_steps(std::size_t i, double gross) {
        for (std::size_t k = 0; k < all_.size(); ++k) {
            double sum = k == 0 ? gross : 0;
            if (water_) sum += water_->fluxes()[k].steps[i];
            for (FluxTally& tally : all_[k]) tally.steps[i] = sum;
        }
    }

    void add_nights() {
        water_->add_nights();
        for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
            if (light_.beam_of[i] < 0 && light_.sky_of[i] < 0) take_steps(i, 0);
    }

    void respond(const TimeStep& step, StepLight& light) {
        const std::vector<PairLight::Bin>& bins = light.pair.bins();
        light.responses.clear();
        for (const LeafGroup& leaf : lit_leaves_.leaves)
            light.responses.push_back(
                leaf.photosynthesis
                    ? response(leaf.rates, air_of(step, *leaf.photosynthesis))
                    : LeafResponse{});
        for (std::size_t first = 0, last = 0, b = 0; first < places_.count();
             first = last) {
            const std::uint32_t leaf = places_.group[first];
            while (last < places_.count() && places_.group[last] == leaf)
                ++last;
            light.shaded.respond(light.responses[leaf], first, last);
            const std::size_t first_bin = b;
            while (b < bins.size() && bins[b].place < last) ++b;
            light.lit.respond(light.responses[leaf], first_bin, b);
        }
    }

    //! Sums pseudo-values of places to those of leaves, layers and rows. Errors
    //! of other fluxes are assumed proportional to assimilation's errors.
    void add_up(std::size_t k) {
        for (std::size_t p = 0; p < places_.count(); ++p) {
            double flux = k == 0 ? mean_[p] : 0, times = 1;
            if (water_) {
                const WaterFluxes::Flux& found = water_->fluxes()[k];
                flux += found.mean[p];
                if (k > 0)
                    times =
                        mean_[p] > 0
                            ? std::max(found.size[p], std::abs(flux)) / mean_[p]
                            : 0;
            }
            double mean = 0;
            for (const std::vector<double>& each : differences_)
                mean += each[p] / static_cast<double>(tallies_.size());
            for (std::size_t r = 0; r < tallies_.size(); ++r) {
                const double amount =
                    k == 0 ? flux + differences_[r][p] - mean
                           : flux + times * (differences_[r][p] - mean);
                IDEOTYPE_ENSURE(std::isfinite(amount));
                FluxTally& tally = all_[k][r];
                tally.groups[places_.group[p]] += amount;
                tally.layers[lit_leaves_.layers.at(places_.height[p])] +=
                    amount;
                if (!tally.rows.empty()) tally.rows[places_.row[p]] += amount;
            }
        }
    }

    const std::vector<Tally>& tallies_;
    const LitLeaves& lit_leaves_;
    const SeriesIllumination& light_;
    LeafPlaces places_;
    ExpectedLight expectation_;
    std::optional<WaterFluxes> water_{};
    std::vector<double> mean_;  //!< gross assimilation of places
    //! Differences [randomisation][place], without the part that all
    //! randomisations share.
    std::vector<std::vector<double>> differences_;
    FluxTallies all_;  //!< pseudo-values of each LeafFlux
    // Weights of the moments of each place, summed over the steps that share a
    // sun and a sky.
    std::vector<Moments> weights_;
    double whole_ = 0;  //!< gross assimilation in steps of one sun and sky
};

}  // namespace

FluxTallies assimilate(const std::vector<Tally>& tallies, const Pieces& pieces,
                       const LitLeaves& lit) {
    // The jackknife of a product leaves out two randomisations at a time.
    IDEOTYPE_EXPECT(tallies.size() == 1 || tallies.size() > 2);
    IDEOTYPE_EXPECT(lit.photons > 0);
    return Assimilation(tallies, pieces, lit).result();
}

}  // namespace ideotype
