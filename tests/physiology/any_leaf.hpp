// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>
#include <string>

#include <nlohmann/json.hpp>

#include "ideotype/physiology/energy_balance.hpp"

namespace ideotype {

//! A point of a leaf with the air around it.
struct Case {
    std::string name;
    ThermalLeaf leaf;
    LeafSurroundings around;
    nlohmann::json expected;
};

//! Generates leaves and air of all kinds in a reproducible order.
class AnyLeaf {
  public:
    Case next() {
        const bool is_lit = count_ % 5 != 0, is_medlyn = count_ % 4 < 2;
        Case made;
        LeafSurroundings& in = made.around;
        in.temperature = between(-5, 52);
        in.humidity = count_ % 20 == 0 ? 1 : between(0, 1);
        in.ppfd = is_lit ? between(0, 2500) : 0;
        in.nir = is_lit ? between(0, 500) : 0;
        in.longwave =
            between(1.5, 2.1) * 5.67e-8 * std::pow(in.temperature + 273.15, 4);
        in.co2 = between(150, 1000);
        in.pressure = between(60, 105);
        in.wind = count_ % 7 == 0 ? 0 : std::pow(10, between(-3, 1.1));
        in.width = std::pow(10, between(-2.3, -.6));
        if (count_ % 2 == 0)
            made.leaf.rates = CollatzLeaf{.vmax = between(5, 60)};
        else
            made.leaf.rates = FarquharLeaf{.vcmax = between(10, 150),
                                           .jmax = between(20, 300)};
        made.leaf.stomata = is_medlyn
                                ? Stomata{Stomata::Model::medlyn,
                                          between(0, .03), between(.05, 8)}
                                : Stomata{Stomata::Model::ball_berry,
                                          between(0, .1), between(2, 12)};
        made.leaf.ratio = count_ % 11 == 0   ? 0
                          : count_ % 13 == 0 ? INFINITY
                                             : between(.2, 2);
        ++count_;
        return made;
    }

  private:
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_()) / 0x1p64;
    }

    int count_ = 0;
    std::mt19937_64 random_{37};
};

}  // namespace ideotype
