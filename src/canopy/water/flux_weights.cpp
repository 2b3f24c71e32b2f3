// SPDX-License-Identifier: Apache-2.0
#include "water_fluxes.hpp"

namespace ideotype {

//! Adds the weights that moments have in hot leaf area. Only beams determine
//! which leaves of a place are hot.
void WaterFluxes::weigh_hot(const StepLight& light, double amount,
                            Weights& all) const {
    if (!lines_->reaches_heat(brightest_)) return;
    const std::vector<std::uint32_t>& place = light.pair.bins().place;
    const auto is_hot = [&](std::size_t area) {
        const LeafAir::Point at = point(&light, area);
        const std::uint32_t group = places_.group[at.place];
        return lit_.leaves[group].exchanges_water()
                   ? lines_->at(LeafFlux::hot, group, at)
                   : Expansion{};
    };
    for (std::size_t b = 0; b < place.size(); ++b)
        all.bins.one[b] +=
            amount * light.scales.of_sun *
            gain(is_hot(place[b]), is_hot(places_.count() + b), light.beams[b])
                .value;
}

void WaterFluxes::weigh(LeafFlux flux, const StepLight& light,
                        const Weights& gross, Weights& all) const {
    const auto k = static_cast<std::size_t>(flux);
    if (!takes(flux, &light)) return;
    if (flux == LeafFlux::hot) return weigh_hot(light, amounts_[k], all);
    // Slopes of the flux's line, by place and by bin.
    const bool is_in_gross = LeafLines::is_in_gross(flux);
    const double per = is_in_gross ? amounts_.front() : 1;
    std::vector<double> of_groups, of_places, of_bins;
    for (std::uint32_t g = 0; g < lit_.leaves.size(); ++g)
        of_groups.push_back(lit_.leaves[g].exchanges_water()
                                ? amounts_[k] * lines_->line(flux, g).back()
                                : 0);
    for (const std::uint32_t group : places_.group)
        of_places.push_back(of_groups[group] / per);
    for (const std::uint32_t place : light.pair.bins().place)
        of_bins.push_back(of_places[place]);
    if (is_in_gross) {
        add_weights(gross.places, of_places, all.places);
        add_weights(gross.bins, of_bins, all.bins);
        return;
    }
    for (std::size_t p = 0; p < of_places.size(); ++p) {
        all.places.sun[p] += of_places[p] * light.scales.of_sun;
        all.places.sky[p] += of_places[p] * light.scales.of_sky;
    }
    for (std::size_t b = 0; b < of_bins.size(); ++b)
        all.bins.one[b] += of_bins[b] * light.scales.of_sun;
}

}  // namespace ideotype
