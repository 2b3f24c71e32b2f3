// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "any_leaf.hpp"
#include "ideotype/physiology/leaf_exchange.hpp"
#include "leaf_energy.hpp"

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

std::vector<Case> any_leaves(std::size_t count) {
    AnyLeaf any;
    std::vector<Case> cases;
    while (cases.size() < count) cases.push_back(any.next());
    return cases;
}

std::vector<LeafExchange> solve(std::span<const Case> cases) {
    std::vector<ThermalPoint> points;
    for (const Case& each : cases) points.push_back({&each.leaf, each.around});
    std::vector<LeafExchange> solved(points.size());
    leaf_exchange(points, solved.data());
    return solved;
}

TEST(LeafExchange, OfAPointDoesNotDependOnOthers) {
    const std::vector<Case> cases = any_leaves(100);
    const std::vector<LeafExchange> together = solve(cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const LeafExchange alone = solve({&cases[i], 1}).front();
        EXPECT_EQ(alone.temperature, together[i].temperature);
        EXPECT_EQ(alone.net.value, together[i].net.value);
        EXPECT_EQ(alone.net.curvature, together[i].net.curvature);
        EXPECT_EQ(alone.transpiration.slope, together[i].transpiration.slope);
        EXPECT_EQ(alone.conductance, together[i].conductance);
    }
}

TEST(CubeRoot, IsExactToRounding) {
    for (double x = 1e-300; x < 1e300; x *= 1.37)
        EXPECT_NEAR(cube_root(x) / std::cbrt(x), 1, 1e-15);
    EXPECT_EQ(cube_root(0), 0);
}

TEST(LeafExchange, IsTheEnergyBalanceOfAnyLeaf) {
    const std::vector<Case> cases = any_leaves(10000);
    const std::vector<LeafExchange> solved = solve(cases);
    double largest = 0, largest_net = 0, left = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(i);
        const Case& each = cases[i];
        const EnergyBalance exact = energy_balance(each.leaf, each.around);
        const LeafExchange& found = solved[i];
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
