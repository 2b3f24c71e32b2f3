// SPDX-License-Identifier: Apache-2.0
// Leaf models in C++: net assimilation of a C4 and a C3 leaf in strong light.
//
// The models of Collatz et al. 1992 and of Farquhar et al. 1980, from 5 to 45
// deg C, each with the intercellular CO2 of its stomatal model.
// Photorespiration reduces C3 assimilation in heat. This example uses the
// physiology library.
#include <cstdio>

#include <ideotype/physiology/collatz.hpp>
#include <ideotype/physiology/farquhar.hpp>
#include <ideotype/physiology/temperature.hpp>

using namespace ideotype;

int main() {
    constexpr double light = 1500;  // absorbed [umol m-2 s-1]
    const CollatzLeaf maize;
    const FarquharLeaf soybean;
    std::printf(
        "temperature [deg C],C4 as maize [umol m-2 s-1],C3 as soybean\n");
    double best = 0, warmth = 0;
    for (double t = 5; t <= 45; t += 2.5) {
        const double dry = vapour_deficit(t, .6);
        const double c4 =
            collatz_at(maize, t, ci_of_deficit(dry)).gross(light) -
            dark_respiration(maize, t);
        const double c3 =
            farquhar_at(soybean, t, ci_of_optimal_stomata(dry, soybean.g1))
                .gross(light) -
            dark_respiration(soybean, t);
        std::printf("%g,%.3f,%.3f\n", t, c4, c3);
        if (c4 > best) {
            best = c4;
            warmth = t;
        }
    }
    // C4 leaves have a high temperature optimum.
    return warmth > 30 && warmth < 42 ? 0 : 1;
}
