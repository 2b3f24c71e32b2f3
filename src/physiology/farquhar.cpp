// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/farquhar.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/physiology/temperature.hpp"

namespace ideotype {

namespace {

//! Returns exp(c - E / R T), with an activation energy E [kJ mol-1].
double arrhenius(double c, double energy, double temperature) {
    return std::exp(c - energy / (gas_constant * (temperature + kelvin)));
}

//! Returns a rate at a temperature [deg C] relative to 25 deg C.
double rise(double energy, double temperature) {
    return arrhenius(0, energy, temperature) / arrhenius(0, energy, 25);
}

//! Returns the capacity of triose phosphate use relative to 25 deg C.
double triose_use(double temperature) {
    const auto fall = [](double t) {
        return 1 + arrhenius(0.65 / gas_constant, 201.8, t);
    };
    return rise(53.1, temperature) * fall(25) / fall(temperature);
}

//! Returns the electrons per absorbed photon [-], for dark-adapted leaves.
double electron_yield(double temperature) {
    const double of_photosystem =
        0.352 + 0.022 * temperature - 0.00034 * temperature * temperature;
    return 0.5 * std::max(of_photosystem, 0.0);
}

}  // namespace

FarquharFactors::FarquharFactors(double temperature)
    : compensation(arrhenius(19.02, 37.83, temperature)),
      half_rate(arrhenius(38.05, 79.43, temperature) *
                (1 + 210 / arrhenius(20.30, 36.38, temperature))),
      vcmax(ideotype::rise(65.33, temperature)),
      tpu(triose_use(temperature)),
      jmax(ideotype::rise(43.5, temperature)),
      yield(electron_yield(temperature)),
      rise(0.018 * (temperature - 25)),
      curvature(0.00037 * (temperature * temperature - 25 * 25)),
      respiration(ideotype::rise(46.39, temperature)) {}

Colimitation farquhar_at(const FarquharLeaf& leaf, double temperature,
                         double ci) {
    return FarquharAt(leaf, temperature)(ci);
}

double dark_respiration(const FarquharLeaf& leaf, double temperature) {
    return leaf.respiration * rise(46.39, temperature);
}

double ci_of_optimal_stomata(double deficit, double g1, double ambient) {
    return ambient * g1 / (g1 + std::sqrt(std::max(deficit, 0.05)));
}

}  // namespace ideotype
