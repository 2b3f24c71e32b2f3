// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include "contracts.hpp"
#include "ideotype/physiology/leaf_exchange.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

TEST(Contracts, OfLeavesAreNoticed) {
    Photosynthesis unranked;
    unranked.profile = CapacityProfile::rank;
    unranked.rank_capacity.clear();
    LeafSurroundings no_blade, vacuum;
    no_blade.width = 0;
    vacuum.pressure = 0;
    expect_noticed({
        {"!points.empty()",
         [&] {
             rates_of_leaves(unranked, {1, 1});
         }},
        {"factor >= 0", [] { scaled(HyperbolaLeaf{}, -1); }},
        {"air.boundary > 0 && air.co2 >= 0",
         [] {
             balance(CollatzLeaf{}, {}, {400, 2, 0}, 1000, 25);
         }},
        {"around.width > 0 && around.pressure > 0",
         [&] { energy_balance({}, no_blade); }},
        {"around.width > 0 && around.pressure > 0",
         [&] { leaf_exchange({}, vacuum, nullptr); }},
    });
}

}  // namespace ideotype
