// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "ideotype/physiology/depth.hpp"

namespace ideotype {
namespace {

const std::vector<double> areas{0.4, 0.5, 0.3, 0.2};  //!< the lowest leaf first

TEST(Depth, IsTheLeafAreaAbovePlusHalfOfTheLeaf) {
    const std::vector<double> depth = depth_of_leaves(areas);
    EXPECT_DOUBLE_EQ(depth[3], .1);
    EXPECT_DOUBLE_EQ(depth[2], .2 + .15);
    EXPECT_DOUBLE_EQ(depth[1], .5 + .25);
    EXPECT_DOUBLE_EQ(depth[0], 1. + .2);
    EXPECT_TRUE(depth_of_leaves({}).empty());
}

TEST(Depth, ProfileIsExponential) {
    const std::vector<double> profile = exponential_profile(areas, .25);
    EXPECT_DOUBLE_EQ(profile[0], std::exp(-.25 * 1.2));
    EXPECT_DOUBLE_EQ(profile[3], std::exp(-.25 * .1));
    for (const double flat : exponential_profile(areas, 0)) EXPECT_EQ(flat, 1);
}

TEST(Depth, NitrogenSumsToThatOfTheCanopy) {
    for (const double factor : {.5, 1., 5.}) {
        std::vector<double> lai = areas;
        for (double& each : lai) each *= factor;
        const std::vector<double> n = nitrogen_of_leaves(lai);
        EXPECT_NEAR(std::inner_product(n.begin(), n.end(), lai.begin(), 0.),
                    4.5, 1e-12);
        EXPECT_NEAR(n[0] / n[3], std::exp(-.25 * 1.1 * factor), 1e-12);
    }
    EXPECT_EQ(nitrogen_of_leaves({0, 0})[1], 0);
}

TEST(Depth, CapacityFollowsNitrogen) {
    EXPECT_DOUBLE_EQ(nitrogen_response(1.8), 1);
    EXPECT_DOUBLE_EQ(nitrogen_response(.25), 0);
    EXPECT_EQ(nitrogen_response(.1), 0);
    // Expected value: the equivalent function tanh(2.9 (N - 0.25) / 2).
    EXPECT_NEAR(nitrogen_response(1.3),
                std::tanh(1.45 * 1.05) / std::tanh(1.45 * 1.55), 1e-14);
    // In a very dense canopy, too little nitrogen is left for the lowest
    // leaves.
    const std::vector<double> n = nitrogen_of_leaves(std::vector(10, .75));
    EXPECT_EQ(nitrogen_response(n[0]), 0);
    EXPECT_GT(nitrogen_response(n[9]), .7);
}

}  // namespace
}  // namespace ideotype
