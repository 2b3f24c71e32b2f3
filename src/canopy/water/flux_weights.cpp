// SPDX-License-Identifier: Apache-2.0
#include "water_fluxes.hpp"

namespace ideotype {

//! Adds the weights that moments have in hot leaf area. Only beams determine
//! which leaves of a place are hot.
void WaterFluxes::weigh_hot(const StepLight& light, double amount,
                            Weights& all) const {
    if (!lines_->reaches_heat(brightest_)) return;
    const std::vector<PairLight::Bin>& bins = light.pair.bins();
    const auto is_hot = [&](std::size_t area) {
        const LeafAir::Point at = point(&light, area);
        const std::uint32_t group = places_.group[at.place];
        return lit_.leaves[group].exchanges_water()
                   ? lines_->at(LeafFlux::hot, group, at)
                   : Expansion{};
    };
    for (std::size_t b = 0; b < bins.size(); ++b)
        all.bins[b].one += amount * light.scales.of_sun *
                           gain(is_hot(bins[b].place),
                                is_hot(places_.count() + b), light.beams[b])
                               .value;
}

void WaterFluxes::weigh(LeafFlux flux, const StepLight& light,
                        const Weights& gross, Weights& all) const {
    const auto k = static_cast<std::size_t>(flux);
    if (!takes(flux, &light)) return;
    if (flux == LeafFlux::hot) return weigh_hot(light, amounts_[k], all);
    std::vector<double> slopes;
    for (std::uint32_t g = 0; g < lit_.leaves.size(); ++g)
        slopes.push_back(lit_.leaves[g].exchanges_water()
                             ? amounts_[k] * lines_->line(flux, g).back()
                             : 0);
    const std::vector<PairLight::Bin>& bins = light.pair.bins();
    const auto slope_of = [&](std::uint32_t place) {
        return slopes[places_.group[place]];
    };
    if (LeafLines::is_in_gross(flux)) {
        for (std::uint32_t p = 0; p < places_.count(); ++p)
            all.places[p].add(gross.places[p], slope_of(p) / amounts_.front());
        for (std::size_t b = 0; b < bins.size(); ++b)
            all.bins[b].add(gross.bins[b],
                            slope_of(bins[b].place) / amounts_.front());
        return;
    }
    for (std::uint32_t p = 0; p < places_.count(); ++p) {
        all.places[p].sun += slope_of(p) * light.scales.of_sun;
        all.places[p].sky += slope_of(p) * light.scales.of_sky;
    }
    for (std::size_t b = 0; b < bins.size(); ++b)
        all.bins[b].one += slope_of(bins[b].place) * light.scales.of_sun;
}

}  // namespace ideotype
