// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/assimilation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "ideotype/canopy/water.hpp"
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
          places_(pieces, lit, tallies),
          of_places_(places_.count()),
          mean_(places_.part_index.size()) {
        FluxTally none{std::vector<double>(lit.leaves.size()),
                       std::vector<double>(lit.layers.count),
                       std::vector<double>(light_.series.steps.size()),
                       std::vector<double>(pieces.rows)};
        all_.assign(lit.air ? leaf_fluxes : 1, {tallies.size(), none});
        noise_.assign(all_.size(), Noise(tallies.size(), places_));
        if (lit.air) water_.emplace(lit, places_, all_);
    }

    CanopyFluxes result() {
        std::map<int, std::map<int, std::vector<std::size_t>>> steps;
        for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
            if (light_.beam_of[i] >= 0 || light_.sky_of[i] >= 0)
                steps[light_.sky_of[i]][light_.beam_of[i]].push_back(i);
        for (const auto& [of_sky, beams] : steps) {
            SkyLight sky(tallies_, of_sky, places_);
            for (Noise& each : noise_) each.sky = SkyWeights(places_);
            for (const auto& [beam, of_pair] : beams) add(beam, sky, of_pair);
            sky.add_amounts(noise_.front().sky, mean_);
            if (tallies_.size() == 1) continue;
            for (Noise& each : noise_) sky.scatter(each.sky, each.differences);
        }
        if (water_) add_nights();
        for (std::size_t k = 0; k < all_.size(); ++k) add_up(k);
        if (water_) water_->add_drawn_to(all_);
        return {std::move(all_),
                water_ ? water_->closed() : std::vector<ClosedStomata>{}};
    }

  private:
    //! The error of a flux due to the error of light. It is computed to first
    //! order in the flux of leaves and to second order in their light.
    struct Noise {
        Noise(std::size_t randomisations, const LeafPlaces& places)
            : sky(places),
              differences(randomisations,
                          std::vector<double>(places.part_index.size())) {}

        Weights weights{};  //!< weights, summed over steps of one sun and sky
        SkyWeights sky;     //!< weights, summed over steps of one sky
        //! Sum of absolute amounts in steps of one sun and sky.
        double whole = 0;
        //! Differences [randomisation][part], without the part common to all
        //! randomisations.
        std::vector<std::vector<double>> differences;
    };

    //! Adds the steps that share a sun and a sky.
    void add(int beam, const SkyLight& sky,
             const std::vector<std::size_t>& steps) {
        const PairLight pair(tallies_, lit_leaves_, places_, beam, sky);
        for (Noise& each : noise_) {
            each.weights.places.assign(places_.count());
            each.weights.bins.assign(pair.bins().size());
            each.whole = 0;
        }
        if (water_) water_->meet(beam, sky.source);
        StepLight light{pair};
        light.shaded.resize(places_.count());
        light.lit.resize(pair.bins().size());
        light.gains.resize(pair.bins().size());
        light.beams.resize(pair.bins().size());
        if (water_) {
            of_step_.places.assign(places_.count());
            of_step_.bins.assign(pair.bins().size());
        }
        for (const std::size_t i : steps) add(i, beam, sky, light);
        pair.add_amounts(noise_.front().weights, of_places_, mean_);
        for (Noise& each : noise_) pair.add_sky(each.weights, each.sky);
        if (tallies_.size() == 1) return;
        for (std::size_t k = 0; k < all_.size(); ++k) {
            Noise& noise = noise_[k];
            if (noise.whole == 0) continue;
            const std::vector<double> sums =
                pair.scatter(noise.weights, noise.sky, noise.differences);
            const double mean = average(sums);
            // The error of each step is assumed to be proportional to its
            // absolute value.
            for (std::size_t r = 0; r < sums.size(); ++r)
                for (const std::size_t i : steps) {
                    double& flux = all_[k][r].steps[i];
                    const double more = (sums[r] - mean) / noise.whole;
                    flux *= flux < 0 ? 1 - more : 1 + more;
                }
        }
    }

    //! Adds a step, and the weights that moments have in its fluxes.
    void add(std::size_t i, int beam, const SkyLight& sky, StepLight& light) {
        const TimeStep& step = light_.series.steps[i];
        const auto scale = [&](int source, double irradiance) {
            if (source < 0) return 0.;
            return irradiance * lit_leaves_.photons /
                   light_.light.sources[static_cast<std::size_t>(source)]
                       .energy;
        };
        light.scales = {scale(beam, step.par.beam),
                        scale(sky.source, step.par.diffuse)};
        const PairLight::Bins& bins = light.pair.bins();
        add_light(light.scales, light.pair.expected(), sky.expected,
                  light.shaded.light);
        add_beams(step.par.beam, bins.photons, bins.place, light.shaded,
                  light.beams, light.lit.light);
        respond(step, light);
        find_gains(light.shaded, light.lit, bins.place, light.beams,
                   light.gains);
        const double amount =
            amount_of(LeafFlux::uptake, step) / light_.series.days;
        Weights& weights = noise_.front().weights;
        bound_curvatures(light.scales, light.pair.moments(), light.shaded);
        bound_curvatures(light.scales, bins.moments, light.gains);
        weigh(light.scales, light.shaded, amount, light.pair.moments(),
              weights.places, water_ ? &of_step_.places : nullptr,
              light.of_places);
        weigh(light.scales, light.gains, amount * light.scales.of_sun,
              bins.moments, weights.bins, water_ ? &of_step_.bins : nullptr,
              of_bins_);
        for (std::size_t b = 0; b < bins.size(); ++b)
            light.of_places[bins.place[b]] += of_bins_[b];
        double whole = 0;
        for (const double sum : light.of_places) whole += sum;
        noise_.front().whole += std::abs(whole);
        if (water_) {
            water_->add(i, light);
            weigh_water(i, light);
        }
        take_steps(i, whole / amount);
    }

    //! Adds the weights that moments have in the step's fluxes of water and
    //! heat. Errors of assimilation are computed at air temperature.
    void weigh_water(std::size_t i, const StepLight& light) {
        if (tallies_.size() == 1) return;
        const TimeStep& step = light_.series.steps[i];
        for (std::size_t k = 1; k < all_.size(); ++k) {
            const auto flux = static_cast<LeafFlux>(k);
            noise_[k].whole += amount_of(flux, step) / light_.series.days *
                               std::abs(water_->fluxes()[k].steps[i]);
            water_->weigh(flux, light, of_step_, noise_[k].weights);
        }
    }

    //! Adds the fluxes of a step to all tallies.
    //! @param gross gross assimilation at air temperature
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
        const std::vector<std::uint32_t>& bins = light.pair.bins().place;
        light.responses.clear();
        const Photosynthesis* last_model = nullptr;
        std::optional<LeavesInAir> air;
        for (const LeafGroup& leaf : lit_leaves_.leaves) {
            if (leaf.photosynthesis && leaf.photosynthesis != last_model) {
                last_model = leaf.photosynthesis;
                air.emplace(air_of(step, *last_model));
            }
            light.responses.push_back(leaf.photosynthesis
                                          ? air->response(leaf.rates)
                                          : LeafResponse{});
        }
        for (std::size_t first = 0, last = 0, b = 0; first < places_.count();
             first = last) {
            const std::uint32_t leaf = places_.group[first];
            while (last < places_.count() && places_.group[last] == leaf)
                ++last;
            light.shaded.respond(light.responses[leaf], first, last);
            const std::size_t first_bin = b;
            while (b < bins.size() && bins[b] < last) ++b;
            light.lit.respond(light.responses[leaf], first_bin, b);
        }
    }

    //! Adds the pseudo-values of parts to those of groups, layers and rows. The
    //! fluxes of a place that are not known by part are shared by area.
    void add_up(std::size_t k) {
        for (std::size_t p = 0; p < places_.count(); ++p) {
            double of_place = k == 0 ? of_places_[p] : 0;
            if (water_) of_place += water_->fluxes()[k].mean[p];
            places_.for_parts(
                p, [&](std::size_t j, double height, double share) {
                    add_part(k, p, j, lit_leaves_.layers.at(height),
                             (k == 0 ? mean_[j] : 0) + share * of_place);
                });
        }
    }

    void add_part(std::size_t k, std::size_t place, std::size_t part,
                  std::size_t layer, double flux) {
        const std::vector<std::vector<double>>& differences =
            noise_[k].differences;
        double mean = 0;
        for (const std::vector<double>& each : differences)
            mean += each[part] / static_cast<double>(tallies_.size());
        for (std::size_t r = 0; r < tallies_.size(); ++r) {
            const double amount = flux + differences[r][part] - mean;
            IDEOTYPE_ENSURE(std::isfinite(amount));
            FluxTally& tally = all_[k][r];
            tally.groups[places_.group[place]] += amount;
            tally.layers[layer] += amount;
            if (!tally.rows.empty()) tally.rows[places_.row[place]] += amount;
        }
    }

    const std::vector<Tally>& tallies_;
    const LitLeaves& lit_leaves_;
    const SeriesIllumination& light_;
    LeafPlaces places_;
    std::optional<WaterFluxes> water_{};
    //! Gross assimilation in proportion to area, by place.
    std::vector<double> of_places_;
    std::vector<double> mean_;    //!< other gross assimilation, by part
    std::vector<Noise> noise_{};  //!< noise by LeafFlux
    //! Weights in the gross assimilation of a step, with water, and amounts of
    //! bins.
    Weights of_step_{};
    std::vector<double> of_bins_{};
    FluxTallies all_;  //!< pseudo-values by LeafFlux
};

}  // namespace

CanopyFluxes assimilate(const std::vector<Tally>& tallies, const Pieces& pieces,
                        const LitLeaves& lit) {
    // The jackknife of a product omits two randomisations at a time.
    IDEOTYPE_EXPECT(tallies.size() == 1 || tallies.size() > 2);
    IDEOTYPE_EXPECT(lit.photons > 0);
    return Assimilation(tallies, pieces, lit).result();
}

}  // namespace ideotype
