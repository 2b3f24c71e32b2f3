// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/physiology/soil_water.hpp"

namespace ideotype {
namespace {

//! The numbers are those of example 18 of FAO-56: Uccle, 6 July.
TEST(SoilWater, ReferenceEvapotranspirationIsThatOfTheSource) {
    const AirOfDay july{16.9, 1.997 - 1.409, 2.078, 100.1, 22.07, 3.71};
    EXPECT_NEAR(reference_evapotranspiration(july), 3.88, 0.02);
    EXPECT_EQ(reference_evapotranspiration({-5, 0, 0, 100, 0, 5}), 0);
}

//! The numbers are those of the equation by hand.
TEST(SoilWater, StrongRainRunsOff) {
    EXPECT_EQ(runoff(0, 100), 0);
    const double most = 254 * (100 / 75. - 1);
    EXPECT_EQ(runoff(75, 0.2 * most), 0);
    EXPECT_NEAR(runoff(75, 50), 9.28, 0.01);
    EXPECT_EQ(runoff(100, 50), 50);
    Soil soil;
    soil.curve_number = 75;
    SoilWater water{100, 20};
    const SoilFluxes out = pass_day(soil, {0, 0, 50, 0, 1}, water);
    EXPECT_NEAR(out.runoff, 9.28, 0.01);
    EXPECT_NEAR(water.depletion, 100 - 50 + out.runoff, 1e-12);
}

}  // namespace
}  // namespace ideotype
