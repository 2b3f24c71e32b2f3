// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/climate/sun.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

const Date august{2025, 8, 7};

Site make_hazy_site(double turbidity, double elevation = 0) {
    return {"Ames", 42.0, -93.6, -5.0, elevation, turbidity};
}

}  // namespace

TEST(ExtraterrestrialNormal, IrradianceFollowsTheDistanceOfTheSun) {
    // The Earth-sun distance is 0.98329 au at perihelion and 1.01671 au at
    // aphelion.
    EXPECT_NEAR(extraterrestrial_normal({2025, 1, 4}),
                1361.1 / (0.98329 * 0.98329), 2);
    EXPECT_NEAR(extraterrestrial_normal({2025, 7, 4}),
                1361.1 / (1.01671 * 1.01671), 2);
}

TEST(ExtraterrestrialNormal, LastDayOfALeapYearIsDefined) {
    EXPECT_NEAR(extraterrestrial_normal({2024, 12, 31}),
                extraterrestrial_normal({2025, 1, 1}), 0.1);
}

TEST(ClearSky, IrradianceAgreesWithEquationsWorkedByHand) {
    // The sun is in the zenith at sea level: air mass 0.99971, fh1 = fh2 = 1,
    // turbidity 3.
    const double outside = extraterrestrial_normal(august);
    const Irradiance sky = clear_sky(make_hazy_site(3), august, {0, 0});
    const double global = 0.868 * outside * std::exp(-0.0387 * 0.99971 * 3);
    const double beam = 0.827 * outside * std::exp(-0.09 * 0.99971 * 2);
    EXPECT_NEAR(sky.beam, beam, 1e-4 * beam);
    EXPECT_NEAR(sky.beam + sky.diffuse, global, 1e-4 * global);
}

TEST(ClearSky, SkyIsDarkWithTheSunBelowTheHorizon) {
    for (const double zenith : {90.0, 90.001, 97.0, 120.0, 180.0}) {
        const Irradiance sky =
            clear_sky(make_hazy_site(3), august, {zenith, 0});
        EXPECT_EQ(sky.beam, 0) << zenith;
        EXPECT_EQ(sky.diffuse, 0) << zenith;
    }
}

TEST(ClearSky, IrradianceIsNeitherNegativeNorAboveExtraterrestrial) {
    for (const double turbidity : {0.5, 1.0, 2.0, 3.0, 5.0, 8.0})
        for (const double elevation : {-400.0, 0.0, 1500.0, 4500.0})
            for (double zenith = 0; zenith < 90; zenith += 0.25) {
                const Irradiance sky =
                    clear_sky(make_hazy_site(turbidity, elevation), august,
                              {zenith, 180});
                ASSERT_GE(sky.beam, 0) << turbidity << " " << zenith;
                ASSERT_GE(sky.diffuse, 0) << turbidity << " " << zenith;
                ASSERT_LT(sky.beam + sky.diffuse,
                          1.1 * extraterrestrial_normal(august) *
                                  std::cos(zenith * degree) +
                              1e-9)
                    << turbidity << " " << elevation << " " << zenith;
            }
}

TEST(ClearSky, HazeTurnsBeamIntoDiffuseLight) {
    const SunPosition sun{45, 180};
    const Irradiance clear = clear_sky(make_hazy_site(2), august, sun);
    const Irradiance hazy = clear_sky(make_hazy_site(6), august, sun);
    EXPECT_LT(hazy.beam, 0.8 * clear.beam);
    EXPECT_GT(hazy.diffuse, 1.2 * clear.diffuse);
}

TEST(ClearSky, BeamIsBrighterOnAMountain) {
    const SunPosition sun{45, 180};
    EXPECT_GT(clear_sky(make_hazy_site(3, 3000), august, sun).beam,
              1.05 * clear_sky(make_hazy_site(3, 0), august, sun).beam);
}

}  // namespace ideotype
