// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/collatz.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/physiology/hyperbola.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {

CollatzFactors::CollatzFactors(double temperature)
    : capacity(c4_temperature_response(temperature)),
      co2(q10(temperature, 25)),
      respiration(co2 / (1 + std::exp(1.3 * (temperature - 55)))) {}

Colimitation collatz_at(const CollatzLeaf& leaf, double temperature,
                        double ci) {
    return CollatzAt(leaf, temperature)(ci);
}

double dark_respiration(const CollatzLeaf& leaf, double temperature) {
    return leaf.respiration * q10(temperature, 25) /
           (1 + std::exp(1.3 * (temperature - 55)));
}

double ci_of_deficit(double deficit, double ambient) {
    return ambient * std::max(0.84 - 0.19 * deficit, 0.0);
}

}  // namespace ideotype
