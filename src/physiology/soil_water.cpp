// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/soil_water.hpp"

#include <algorithm>

#include "ideotype/core/contract.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {

namespace {

//! Returns 1 up to a first depletion, 0 from a last one on, and linear in
//! between.
double falling(double depletion, double first, double last) {
    if (depletion <= first) return 1;
    return last > first
               ? std::clamp((last - depletion) / (last - first), 0., 1.)
               : 0;
}

}  // namespace

double water_stress(const Soil& soil, double root_depth, double depletion) {
    const double available = soil.available(root_depth);
    return falling(depletion, soil.depletion_fraction * available, available);
}

double runoff(double curve_number, double rain) {
    if (!(curve_number > 0)) return 0;
    const double most = 254 * (100 / curve_number - 1);
    const double above = rain - 0.2 * most;
    return above > 0 ? above * above / (rain + 0.8 * most) : 0;
}

double reference_evapotranspiration(const AirOfDay& air) {
    constexpr double albedo = 0.23;
    const double t = air.temperature;
    const double slope =
        4098 * saturated_vapour(t) / ((t + 237.3) * (t + 237.3));
    const double psychrometric = 0.665e-3 * air.pressure;
    const double net = (1 - albedo) * air.radiation - air.longwave_loss;
    return std::max((0.408 * slope * net +
                     psychrometric * 900 / (t + 273) * air.wind * air.deficit) /
                        (slope + psychrometric * (1 + 0.34 * air.wind)),
                    0.);
}

SoilFluxes pass_day(const Soil& soil, const SoilDay& day, SoilWater& water) {
    IDEOTYPE_EXPECT(soil.field_capacity > soil.wilting_point &&
                    soil.total_evaporable >= soil.readily_evaporable);
    IDEOTYPE_EXPECT(day.potential_transpiration >= 0 &&
                    day.potential_evaporation >= 0 && day.rain >= 0 &&
                    day.irrigation >= 0 && day.root_depth >= 0);
    SoilFluxes out;
    out.runoff = runoff(soil.curve_number, day.rain);
    const double wetting = day.rain - out.runoff + day.irrigation;
    const double available = soil.available(day.root_depth);
    // After wetting, first the surface evaporates, then plants transpire.
    const double surface = std::max(water.evaporable_depletion - wetting, 0.);
    const double roots = std::max(water.depletion - wetting, 0.);
    const double reduction =
        falling(surface, soil.readily_evaporable, soil.total_evaporable);
    out.evaporation =
        std::max(std::min({reduction * day.potential_evaporation,
                           soil.total_evaporable - surface, available - roots}),
                 0.);
    out.transpiration =
        std::max(std::min(water_stress(soil, day.root_depth, roots) *
                              day.potential_transpiration,
                          available - roots - out.evaporation),
                 0.);
    // Water above field capacity drains at once.
    out.drainage = std::max(
        wetting - out.evaporation - out.transpiration - water.depletion, 0.);
    water.evaporable_depletion = surface + out.evaporation;
    // A root zone that drains is at field capacity, exactly.
    water.depletion = out.drainage > 0 ? 0
                                       : water.depletion + out.evaporation +
                                             out.transpiration - wetting;
    return out;
}

}  // namespace ideotype
