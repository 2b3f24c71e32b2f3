// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/climate/light_series.hpp"

namespace ideotype {

namespace {

const Date august{2025, 8, 7};
const Site ames{"Ames", 42.0, -93.6, -5.0};
const Site tromso{"Tromso", 69.65, 18.96, 1};

constexpr double minute = 1. / 60;

}  // namespace

// The hours and the angle at Ames were computed with pvlib 0.16 (NREL SPA,
// without refraction).
TEST(Daylight, SunriseNoonAndSunsetAreOnTheLocalClock) {
    const Daylight day = daylight(ames, august);
    ASSERT_TRUE(day.sunrise && day.sunset);
    EXPECT_NEAR(*day.sunrise, 6.3206, minute);
    EXPECT_NEAR(day.noon, 13.3339, minute);
    EXPECT_NEAR(*day.sunset, 20.3392, minute);
    EXPECT_NEAR(day.elevation, 64.1878, 0.01);
}

TEST(Daylight, SunriseNoonAndSunsetMoveWithTheClock) {
    const Site winter_time{"Ames", 42.0, -93.6, -6.0};
    const Daylight summer = daylight(ames, august);
    const Daylight winter = daylight(winter_time, august);
    EXPECT_NEAR(winter.noon, summer.noon - 1, 1e-3);
    EXPECT_NEAR(*winter.sunrise, *summer.sunrise - 1, 1e-3);
    EXPECT_NEAR(*winter.sunset, *summer.sunset - 1, 1e-3);
}

TEST(Daylight, PolarDaysAndNightsHaveNoSunrise) {
    const Daylight night = daylight(tromso, {2025, 12, 21});
    EXPECT_FALSE(night.sunrise || night.sunset);
    EXPECT_NEAR(night.elevation, 90 - 69.65 - 23.44, 0.02);
    const Daylight day = daylight(tromso, {2025, 6, 21});
    EXPECT_FALSE(day.sunrise || day.sunset);
    EXPECT_NEAR(day.elevation, 90 - 69.65 + 23.44, 0.02);
}

TEST(ClockAhead, LeadIsTheOffsetLessFourMinutesPerDegree) {
    EXPECT_NEAR(clock_ahead(ames), 1.24, 1e-12);
    EXPECT_NEAR(clock_ahead(tromso), 1 - 1.264, 1e-12);
    // Kiritimati lies east of 180 deg, but its clock is that of a time zone
    // west of it.
    EXPECT_NEAR(clock_ahead({"Kiritimati", 1.87, -157.4, 14}), 0.49333, 1e-5);
}

TEST(ShareLeftOut, ShareIsTheLightBeforeTheStartAndAfterTheEnd) {
    EXPECT_EQ(share_left_out(ames, {{august}, 0, 24, 60}), 0);
    EXPECT_EQ(share_left_out(ames, {{august}, 22, 24, 60}), 1);
    const double noon = daylight(ames, august).noon;
    const double morning = share_left_out(ames, {{august}, 0, noon, 60});
    EXPECT_NEAR(morning, 0.5, 2e-3);
    const double whole = clear_days(ames, {{august}, 0, 24, 1}, 1).incident();
    const double part = clear_days(ames, {{august}, 10, 15, 1}, 1).incident();
    EXPECT_NEAR(share_left_out(ames, {{august}, 10, 15, 60}), 1 - part / whole,
                5e-4);
    EXPECT_EQ(share_left_out(tromso, {{{2025, 12, 21}}, 0, 24, 60}), 0);
}

}  // namespace ideotype
