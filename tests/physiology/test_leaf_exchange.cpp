// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "any_leaf.hpp"
#include "ideotype/physiology/leaf_exchange.hpp"

namespace ideotype {
namespace {

TEST(LeafExchange, IsTheEnergyBalanceOfAnyLeaf) {
    AnyLeaf any;
    double largest = 0, largest_net = 0;
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
        largest =
            std::max(largest, std::abs(found.temperature - exact.temperature));
        largest_net =
            std::max(largest_net, std::abs(found.net.value - exact.net));
    }
    std::printf("largest errors: %.2g deg C, %.2g umol\n", largest,
                largest_net);
}

}  // namespace
}  // namespace ideotype
