// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/crop/grain.hpp"

namespace ideotype {
namespace {

TEST(Grain, KernelsFollowGrowthAroundSilking) {
    const Grain andrade{KernelRule::andrade, 500};
    EXPECT_EQ(kernels_per_plant(andrade, 1.17), 0);
    EXPECT_EQ(kernels_per_plant(andrade, -1), 0);
    EXPECT_NEAR(kernels_per_plant(andrade, 4.2), 500, 1);
    EXPECT_NEAR(kernels_per_plant(andrade, 2.17), 500 / 1.67, 1e-9);
    const Grain ceres{KernelRule::ceres, 700};
    EXPECT_EQ(kernels_per_plant(ceres, 0), 0);
    EXPECT_NEAR(kernels_per_plant(ceres, 4), 700 * 680 * 4. / 7200 + 50, 1e-9);
    EXPECT_EQ(kernels_per_plant(ceres, 100), 700);
}

TEST(Grain, FillingIsFastestInMildWarmth) {
    EXPECT_EQ(filling_rate(5.5), 0);
    EXPECT_NEAR(filling_rate(10.75), 0.5, 1e-12);
    EXPECT_EQ(filling_rate(16), 1);
    EXPECT_EQ(filling_rate(27), 1);
    EXPECT_NEAR(filling_rate(31), 0.5, 1e-12);
    EXPECT_EQ(filling_rate(40), 0);
}

TEST(Grain, DryMatterIsNeitherMadeNorLost) {
    for (const double sink : {0., 3., 30.})
        for (const double growth : {-4., 0., 5., 40.}) {
            Filling filling{50, 10};
            fill(sink, growth, filling);
            EXPECT_NEAR(filling.grain + filling.reserves + filling.surplus,
                        60 + growth, 1e-12)
                << sink << ' ' << growth;
            EXPECT_GE(filling.reserves, 0);
            EXPECT_LE(filling.grain, 50 + sink);
        }
    // Reserves fill kernels that current growth does not.
    Filling filling{0, 10};
    fill(8, 5, filling);
    EXPECT_EQ(filling.grain, 8);
    EXPECT_EQ(filling.reserves, 7);
    // Half of what kernels do not take enters reserves.
    fill(1, 5, filling);
    EXPECT_EQ(filling.reserves, 9);
    EXPECT_EQ(filling.surplus, 2);
}

}  // namespace
}  // namespace ideotype
