// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/assimilation.hpp"

#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "leaf_air.hpp"
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

//! One flux of the leaves of a field, as far as it is summed.
struct Flux {
    Responses shaded;          //!< of places, in a step
    Responses lit;             //!< of bins
    std::vector<double> mean;  //!< of places
    //! [randomisation][place], but for what all share
    std::vector<std::vector<double>> differences;
    std::vector<FluxTally> all;  //!< pseudo-values
    // Weights of moments in the steps that share a sun and a sky, of places and
    // bins, and of the light of pieces from the sky that steps share.
    std::vector<Moments> weights, weights_of_bins;
    std::vector<double> sky_weight, sky_weight_of_square;
    double whole = 0;  //!< in the steps that share a sun and a sky
};

class Assimilation {
  public:
    Assimilation(const std::vector<Tally>& tallies, const Pieces& pieces,
                 const LitLeaves& lit)
        : tallies_(tallies),
          lit_leaves_(lit),
          light_(lit.par.light),
          places_(pieces, lit, tallies.size() == 1),
          expectation_(places_, tallies),
          fluxes_(lit.air ? leaf_fluxes : 1) {
        for (Flux& flux : fluxes_) {
            flux.shaded.resize(places_.count());
            flux.mean.resize(places_.count());
            flux.differences.assign(tallies.size(),
                                    std::vector<double>(places_.count()));
            flux.all.assign(tallies.size(),
                            {std::vector<double>(lit.leaves.size()),
                             std::vector<double>(lit.layers.count),
                             std::vector<double>(light_.series.steps.size()),
                             std::vector<double>(pieces.rows)});
        }
        if (lit.air) lit.air->see(places_, expectation_);
    }

    FluxTallies result() {
        std::map<int, std::map<int, std::vector<std::size_t>>> steps;
        for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
            if (light_.beam_of[i] >= 0 || light_.sky_of[i] >= 0)
                steps[light_.sky_of[i]][light_.beam_of[i]].push_back(i);
        for (const auto& [of_sky, beams] : steps) {
            SkyLight sky(tallies_, of_sky, places_, expectation_);
            for (Flux& flux : fluxes_) {
                flux.sky_weight = sky.weight;
                flux.sky_weight_of_square = sky.weight_of_square;
            }
            for (const auto& [beam, of_pair] : beams) add(beam, sky, of_pair);
            for (Flux& flux : fluxes_)
                for (std::size_t r = 0; r < tallies_.size(); ++r)
                    for (const auto& [v, x] : sky.light.parts[r])
                        flux.differences[r][places_.of[v]] +=
                            x * (flux.sky_weight[v] +
                                 flux.sky_weight_of_square[v] * x);
        }
        if (lit_leaves_.air) add_nights();
        FluxTallies all;
        for (Flux& flux : fluxes_) {
            add_up(flux);
            all.push_back(std::move(flux.all));
        }
        return all;
    }

  private:
    //! Adds steps that share a sun and a sky.
    void add(int beam, SkyLight& sky, const std::vector<std::size_t>& steps) {
        PairLight pair(tallies_, lit_leaves_, places_, expectation_, beam, sky);
        for (Flux& flux : fluxes_) {
            flux.whole = 0;
            flux.weights.assign(places_.count(), {});
            flux.weights_of_bins.assign(pair.bins().size(), {});
        }
        if (lit_leaves_.air) lit_leaves_.air->meet(beam, sky.source);
        for (const std::size_t i : steps) add(i, beam, sky, pair);
        if (tallies_.size() == 1) return;
        for (Flux& flux : fluxes_)
            if (flux.whole != 0) scatter(flux, sky, pair, steps);
    }

    //! Adds the differences of randomisations in some steps.
    void scatter(Flux& flux, SkyLight& sky, PairLight& pair,
                 const std::vector<std::size_t>& steps) const {
        for (std::size_t b = 0; b < flux.weights_of_bins.size(); ++b)
            pair.bins()[b].weights = flux.weights_of_bins[b];
        sky.weight.swap(flux.sky_weight);
        sky.weight_of_square.swap(flux.sky_weight_of_square);
        const std::vector<double> sums =
            pair.scatter(flux.weights, flux.differences);
        sky.weight.swap(flux.sky_weight);
        sky.weight_of_square.swap(flux.sky_weight_of_square);
        const double mean = std::accumulate(sums.begin(), sums.end(), 0.) /
                            static_cast<double>(sums.size());
        // The errors of its steps are taken as in proportion to them.
        for (std::size_t r = 0; r < sums.size(); ++r)
            for (const std::size_t i : steps)
                flux.all[r].steps[i] *= 1 + (sums[r] - mean) / flux.whole;
    }

    //! Adds a step, and the weights of moments in it.
    void add(std::size_t i, int beam, const SkyLight& sky, PairLight& pair) {
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
        std::vector<PairLight::Bin>& bins = pair.bins();
        Responses& shaded = fluxes_.front().shaded;
        Responses& lit = fluxes_.front().lit;
        for (std::size_t p = 0; p < places_.count(); ++p)
            shaded.light[p] =
                of_sun * pair.expected()[p] + of_sky * sky.expected[p];
        for (Flux& flux : fluxes_) flux.lit.resize(bins.size());
        for (std::size_t b = 0; b < bins.size(); ++b)
            lit.light[b] = shaded.light[bins[b].place] + on_leaf(bins[b]);
        if (lit_leaves_.air)
            exchange(i, of_sun, bins, on_leaf);
        else
            respond(step, bins);
        for (std::size_t k = 0; k < fluxes_.size(); ++k) {
            Flux& flux = fluxes_[k];
            const double amount =
                amount_of(static_cast<LeafFlux>(k), step) / light_.series.days;
            // Other fluxes are taken at the light that is expected.
            const bool is_expanded =
                k <= static_cast<std::size_t>(LeafFlux::transpiration);
            double whole = 0;
            const auto add = [&](const Expansion& at, double times,
                                 const Moments& of, std::size_t place,
                                 Moments& all) {
                if (!is_expanded) {
                    const double sum = times * at.value * of.one;
                    flux.mean[place] += sum;
                    whole += sum;
                    all.one += times * at.value;
                    return;
                }
                const Moments weight{
                    times * at.value,
                    times * at.slope * of_sun,
                    times * at.slope * of_sky,
                    times * at.curvature * of_sun * of_sun / 2,
                    times * at.curvature * of_sun * of_sky,
                    times * at.curvature * of_sky * of_sky / 2};
                const double sum = weight.dot(of);
                flux.mean[place] += sum;
                whole += sum;
                all.add(weight, 1);
            };
            for (std::size_t p = 0; p < places_.count(); ++p)
                add(flux.shaded.at(p), amount, pair.moments()[p], p,
                    flux.weights[p]);
            for (std::size_t b = 0; b < bins.size(); ++b)
                add(gain(flux.shaded.at(bins[b].place), flux.lit.at(b),
                         on_leaf(bins[b])),
                    amount * of_sun, bins[b].moments, bins[b].place,
                    flux.weights_of_bins[b]);
            flux.whole += whole;
            for (FluxTally& tally : flux.all) tally.steps[i] = whole / amount;
        }
    }

    //! Finds the responses of a step leaf by leaf.
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
            fluxes_.front().shaded.respond(responses[leaf], first, last);
            const std::size_t first_bin = b;
            while (b < bins.size() && bins[b].place < last) ++b;
            fluxes_.front().lit.respond(responses[leaf], first_bin, b);
        }
    }

    //! Finds the exchange of leaves with the air in a step.
    void exchange(std::size_t i, double of_sun,
                  const std::vector<PairLight::Bin>& bins,
                  const auto& on_leaf) {
        LeafAir& air = *lit_leaves_.air;
        std::vector<LeafAir::Point>& points = air.points();
        points.clear();
        const Responses &shaded = fluxes_.front().shaded,
                        &lit = fluxes_.front().lit;
        for (std::size_t p = 0; p < places_.count(); ++p)
            points.push_back({p, shaded.light[p], 0, places_.index[p]});
        for (std::size_t b = 0; b < bins.size(); ++b) {
            // Sunlit leaf area is what a hit absorbs over the beam.
            const double beam = on_leaf(bins[b]);
            const double area =
                beam > 0 ? of_sun * bins[b].moments.one / beam : 0;
            points.push_back(
                {bins[b].place, lit.light[b], bins[b].cosine, area});
            points[bins[b].place].area -= area;
        }
        air.exchange(i);
        for (std::size_t k = 0; k < fluxes_.size(); ++k) {
            Flux& flux = fluxes_[k];
            for (std::size_t j = 0; j < points.size(); ++j) {
                Responses& into = j < places_.count() ? flux.shaded : flux.lit;
                const std::size_t at =
                    j < places_.count() ? j : j - places_.count();
                const Expansion& found = air.flux(k, j);
                into.value[at] = found.value;
                into.slope[at] = found.slope;
                into.curvature[at] = found.curvature;
            }
        }
    }

    //! Adds what leaves transpire in steps without light.
    void add_nights() {
        LeafAir& air = *lit_leaves_.air;
        std::vector<LeafAir::Point>& points = air.points();
        air.meet(-1, -1);
        for (std::size_t i = 0; i < light_.beam_of.size(); ++i) {
            if (light_.beam_of[i] >= 0 || light_.sky_of[i] >= 0) continue;
            points.clear();
            for (std::size_t p = 0; p < places_.count(); ++p)
                points.push_back({p, 0, 0, places_.index[p]});
            air.exchange_at_night(i);
            const TimeStep& step = light_.series.steps[i];
            for (const LeafFlux kind :
                 {LeafFlux::transpiration, LeafFlux::sensible}) {
                const auto k = static_cast<std::size_t>(kind);
                Flux& flux = fluxes_[k];
                const double amount =
                    amount_of(kind, step) / light_.series.days;
                double whole = 0;
                for (std::size_t p = 0; p < places_.count(); ++p) {
                    const double sum =
                        amount * places_.index[p] * air.flux(k, p).value;
                    flux.mean[p] += sum;
                    whole += sum;
                }
                for (FluxTally& tally : flux.all)
                    tally.steps[i] = whole / amount;
            }
        }
    }

    //! Sums pseudo-values of places to those of leaves, layers and rows.
    void add_up(Flux& flux) const {
        for (std::size_t p = 0; p < places_.count(); ++p) {
            double mean = 0;
            for (const std::vector<double>& each : flux.differences)
                mean += each[p] / static_cast<double>(tallies_.size());
            for (std::size_t r = 0; r < tallies_.size(); ++r) {
                const double amount =
                    flux.mean[p] + flux.differences[r][p] - mean;
                IDEOTYPE_ENSURE(std::isfinite(amount));
                FluxTally& tally = flux.all[r];
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
    std::vector<Flux> fluxes_;  //!< of LeafFlux
};

}  // namespace

FluxTallies assimilate(const std::vector<Tally>& tallies, const Pieces& pieces,
                       const LitLeaves& lit) {
    // Jackknives of a product are over randomisations but for two.
    IDEOTYPE_EXPECT(tallies.size() == 1 || tallies.size() > 2);
    IDEOTYPE_EXPECT(lit.photons > 0);
    return Assimilation(tallies, pieces, lit).result();
}

}  // namespace ideotype
