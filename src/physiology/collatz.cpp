// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/collatz.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/physiology/hyperbola.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {

Colimitation collatz_at(const CollatzLeaf& leaf, double temperature,
                        double ci) {
    return {leaf.alpha, leaf.vmax * c4_temperature_response(temperature),
            leaf.theta, leaf.beta, leaf.k * q10(temperature, 25) * ci};
}

double dark_respiration(const CollatzLeaf& leaf, double temperature) {
    return leaf.respiration * q10(temperature, 25) /
           (1 + std::exp(1.3 * (temperature - 55)));
}

double ci_of_deficit(double deficit, double ambient) {
    return ambient * std::max(0.84 - 0.19 * deficit, 0.0);
}

namespace {

//! Conductance of stomata that see this assimilation [mol m-2 s-1].
double conductance(const Stomata& stomata, double net, double surface_co2,
                   double humidity) {
    if (net <= 0) return stomata.b0;
    // Humidity at the surface, where as much water passes through stomata as
    // through the boundary layer: a h^2 + b h + c = 0.
    const double a = stomata.b1 * net / surface_co2;
    const double b = stomata.b0 + stomata.boundary - a;
    const double c = -humidity * stomata.boundary - stomata.b0;
    const double h = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
    return stomata.b0 + a * h;
}

}  // namespace

LeafBalance balance(const CollatzLeaf& leaf, const Stomata& stomata,
                    double absorbed, double temperature, double humidity) {
    const double respiration = dark_respiration(leaf, temperature);
    const auto at = [&](double ci) {
        const double net =
            collatz_at(leaf, temperature, ci).gross(absorbed) - respiration;
        const double surface = stomata.ambient - 1.37 * net / stomata.boundary;
        const double gs = conductance(stomata, net, surface, humidity);
        // The CO2 that the stomata let in, less what there would have to be.
        return std::pair{LeafBalance{net, surface - 1.6 * net / gs, gs},
                         surface - 1.6 * net / gs - ci};
    };
    // More CO2 within means more assimilation, so less is let in: one root.
    double low = 0, high = 2 * stomata.ambient;
    while (high - low > 1e-12 * stomata.ambient) {
        const double middle = (low + high) / 2;
        if (middle <= low || middle >= high) break;
        (at(middle).second > 0 ? low : high) = middle;
    }
    LeafBalance result = at((low + high) / 2).first;
    result.ci = (low + high) / 2;
    return result;
}

}  // namespace ideotype
