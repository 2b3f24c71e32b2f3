// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "any_leaf.hpp"
#include "ideotype/physiology/leaf_exchange.hpp"

namespace ideotype {
namespace {

//! Returns the energy that is absorbed but not lost, relative to the absorbed
//! energy.
double part_left(const Case& each, const LeafExchange& found) {
    const LeafSurroundings& in = each.around;
    const double absorbed = in.ppfd / 4.57 + in.nir + in.longwave;
    const double latent_heat = .0180153 * (2.501e6 - 2361 * in.temperature);
    const double lost = 2 * each.leaf.emissivity * 5.670374419e-8 *
                            std::pow(found.temperature + 273.15, 4) +
                        found.sensible +
                        1e-3 * found.transpiration.value * latent_heat;
    return 1 - lost / absorbed;
}

TEST(LeafExchange, IsTheEnergyBalanceOfAnyLeaf) {
    AnyLeaf any;
    double largest = 0, largest_net = 0, left = 0;
    for (int i = 0; i < 10000; ++i) {
        SCOPED_TRACE(i);
        const Case each = any.next();
        const EnergyBalance exact = energy_balance(each.leaf, each.around);
        const LeafExchange found = leaf_exchange(each.leaf, each.around);
        EXPECT_NEAR(found.temperature, exact.temperature, .02);
        EXPECT_NEAR(found.net.value, exact.net,
                    .02 + 1e-3 * std::abs(exact.net));
        EXPECT_NEAR(found.conductance, exact.conductance,
                    .001 + .01 * exact.conductance);
        EXPECT_NEAR(found.transpiration.value, exact.transpiration,
                    .03 + .01 * std::abs(exact.transpiration));
        EXPECT_NEAR(found.sensible, exact.sensible, 1);
        left = std::max(left, std::abs(part_left(each, found)));
        largest =
            std::max(largest, std::abs(found.temperature - exact.temperature));
        largest_net =
            std::max(largest_net, std::abs(found.net.value - exact.net));
    }
    EXPECT_LT(left, 1e-11);
    std::printf(
        "largest errors: %.2g deg C, %.2g umol; energy left %.2g of 1\n",
        largest, largest_net, left);
}

}  // namespace
}  // namespace ideotype
