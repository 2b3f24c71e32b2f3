// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/climate/sun.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {
namespace {

// Expected values: equation 1 of Erbs et al., evaluated by hand;
// test_weather_formats.cpp contains values of pvlib.
TEST(DiffuseFraction, FractionAgreesWithErbs) {
    const double normal = 1000 / std::cos(40 * degree);
    EXPECT_DOUBLE_EQ(diffuse_fraction(0, normal, 40), 1);
    EXPECT_NEAR(diffuse_fraction(100, normal, 40), 1 - .009, 1e-12);
    EXPECT_NEAR(diffuse_fraction(220, normal, 40), 1 - .09 * .22, 1e-12);
    EXPECT_NEAR(diffuse_fraction(500, normal, 40), .65915, 1e-12);
    EXPECT_NEAR(diffuse_fraction(800.001, normal, 40), .165, 1e-12);
    EXPECT_NEAR(diffuse_fraction(3000, normal, 40), .165, 1e-12);
}

TEST(DiffuseFraction, LowSunHasNoBeam) {
    EXPECT_EQ(diffuse_fraction(20, 1361, 87.1), 1);
    EXPECT_EQ(diffuse_fraction(20, 1361, 120), 1);
    // The equation uses a cosine of at least 0.065.
    EXPECT_NEAR(diffuse_fraction(.1 * .065 * 1361, 1361, 86.9), 1 - .009,
                1e-12);
}

}  // namespace
}  // namespace ideotype
