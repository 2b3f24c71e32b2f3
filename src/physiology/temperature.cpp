// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/temperature.hpp"

#include <cmath>

namespace ideotype {

double q10(double temperature, double reference) {
    return std::exp2((temperature - reference) / 10);
}

double c4_temperature_response(double temperature) {
    return q10(temperature, 25) / ((1 + std::exp(0.3 * (3 - temperature))) *
                                   (1 + std::exp(0.3 * (temperature - 37.5))));
}

double saturated_vapour(double temperature) {
    return 0.61078 * std::exp(17.27 * temperature / (temperature + 237.3));
}

double vapour_deficit(double temperature, double humidity) {
    return saturated_vapour(temperature) * (1 - humidity);
}

}  // namespace ideotype
