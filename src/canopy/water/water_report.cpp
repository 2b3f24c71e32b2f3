// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "ideotype/canopy/water.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

void scale(FluxReport& report, double factor) {
    for (FluxTally& tally : report.tallies)
        for (auto* part : {&tally.groups, &tally.layers, &tally.rows})
            for (double& x : *part) x *= factor;
    report.sum = scaled(report.sum, factor);
    for (auto* part : {&report.groups, &report.layers})
        for (Estimate& x : *part) x = scaled(x, factor);
}

}  // namespace

double amount_of(LeafFlux flux, const TimeStep& step) {
    constexpr double millimetres = 1e-3 * 0.0180153, megajoules = 1e-6;
    switch (flux) {
        case LeafFlux::uptake:
        case LeafFlux::respiration:
            return step.seconds * mol_per_umol;
        case LeafFlux::transpiration:
            return step.seconds * millimetres;
        case LeafFlux::sensible:
            return step.seconds * megajoules;
        case LeafFlux::hot:
            return step.seconds / 3600;
        case LeafFlux::warming:
        case LeafFlux::conductance:
            break;
    }
    return step.seconds;
}

WaterReport report(FluxTallies tallies, std::vector<double> leaf_area,
                   const LightSeries& series) {
    IDEOTYPE_EXPECT(tallies.size() == leaf_fluxes);
    const auto take = [&]<LeafFlux flux>() {
        return report(
            std::move(tallies[static_cast<std::size_t>(flux)]), series,
            [](const TimeStep& step) { return amount_of(flux, step); });
    };
    WaterReport result{take.operator()<LeafFlux::transpiration>(),
                       take.operator()<LeafFlux::sensible>(),
                       take.operator()<LeafFlux::warming>(),
                       take.operator()<LeafFlux::conductance>(),
                       take.operator()<LeafFlux::hot>(),
                       std::move(leaf_area)};
    const double lit = series.lit_seconds() / series.days;
    for (FluxReport* each : {&result.warming, &result.conductance})
        scale(*each, lit > 0 ? 1 / lit : 0);
    return result;
}

}  // namespace ideotype
