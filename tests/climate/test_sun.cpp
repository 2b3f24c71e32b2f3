// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "ideotype/climate/sun.hpp"

namespace ideotype {

namespace {

constexpr double tolerance = 0.01;  //!< [deg]

const Site ames{"Ames", 42.0, -93.6, -5.0};

Site make_site_at(double latitude) {
    return {"somewhere", latitude, 0.0, 0.0};
}

}  // namespace

TEST(Date, LeapDaysAreKeptInLeapYears) {
    EXPECT_EQ(in_year({2011, 5, 15}, 2012), (Date{2012, 5, 15}));
    EXPECT_EQ(in_year({2012, 2, 29}, 2016), (Date{2016, 2, 29}));
    EXPECT_EQ(in_year({2012, 2, 29}, 2013), (Date{2013, 2, 28}));
}

TEST(SunPosition, PositionAgreesWithTheTestCaseOfNrelSpa) {
    const Site golden{"Golden", 39.742476, -105.1786, -7.0, 1830.14};
    const SunPosition sun =
        sun_position(golden, {2003, 10, 17}, 12 + 30.5 / 60);
    EXPECT_NEAR(sun.zenith, 50.12795, tolerance);
    EXPECT_NEAR(sun.azimuth, 194.34024, tolerance);
}

TEST(SunPosition, PositionAgreesWithSpaOverADayAtAmes) {
    const SunPosition hourly[] = {
        {82.8404, 74.5338},  {71.9049, 84.1497},  {60.7795, 94.1569},
        {49.8158, 105.5619}, {39.5468, 120.0196}, {31.0020, 140.2981},
        {26.1685, 168.9810}, {27.2025, 201.3213}, {33.5534, 227.1811},
        {42.8421, 245.1487}, {53.4312, 258.3423}, {64.5072, 269.1342},
        {75.6216, 278.9099}, {86.4472, 288.5522}};
    int hour = 7;
    for (const SunPosition& expected : hourly) {
        SCOPED_TRACE("hour " + std::to_string(hour));
        const SunPosition sun = sun_position(ames, {2025, 8, 7}, hour++);
        EXPECT_NEAR(sun.zenith, expected.zenith, tolerance);
        EXPECT_NEAR(sun.azimuth, expected.azimuth, tolerance);
    }
}

TEST(SunPosition, PositionDependsOnlyOnTheInstant) {
    const SunPosition evening = sun_position(ames, {2025, 8, 7}, 26.5);
    const SunPosition next_day = sun_position(ames, {2025, 8, 8}, 2.5);
    EXPECT_NEAR(evening.zenith, next_day.zenith, 1e-9);
    EXPECT_NEAR(evening.azimuth, next_day.azimuth, 1e-9);

    Site greenwich_clock = ames;
    greenwich_clock.utc_offset = 0;
    const SunPosition universal =
        sun_position(greenwich_clock, {2025, 8, 7}, 15);
    const SunPosition local = sun_position(ames, {2025, 8, 7}, 10);
    EXPECT_NEAR(universal.zenith, local.zenith, 1e-9);
    EXPECT_NEAR(universal.azimuth, local.azimuth, 1e-9);
}

TEST(SunPosition, PositionIsFiniteAtEveryLatitudeAndHour) {
    for (const double latitude : {-90.0, -66.6, -23.4, 0.0, 42.0, 66.6, 90.0})
        for (const Date& date :
             {Date{2024, 2, 29}, {2025, 3, 20}, {2025, 6, 21}, {2025, 12, 21}})
            for (double hour = 0; hour <= 24; hour += 0.25) {
                const SunPosition sun =
                    sun_position(make_site_at(latitude), date, hour);
                ASSERT_GE(sun.zenith, 0) << latitude << " " << hour;
                ASSERT_LE(sun.zenith, 180) << latitude << " " << hour;
                ASSERT_GE(sun.azimuth, 0) << latitude << " " << hour;
                ASSERT_LE(sun.azimuth, 360) << latitude << " " << hour;
            }
}

TEST(SunPosition, SunPassesOverheadAtTheEquatorOnTheEquinox) {
    // At 09:01 UTC the declination is zero; the equation of time is -7.4
    // minutes.
    const double noon = 12 + 7.4 / 60;
    const SunPosition sun = sun_position(make_site_at(0), {2025, 3, 20}, noon);
    EXPECT_LT(sun.zenith, 0.1);
    EXPECT_NEAR(sun_position(make_site_at(0), {2025, 3, 20}, noon - 3).azimuth,
                90, 0.2);
    EXPECT_NEAR(sun_position(make_site_at(0), {2025, 3, 20}, noon + 3).azimuth,
                270, 0.2);
}

TEST(SunPosition, SunStaysLevelAtThePole) {
    const SunPosition morning =
        sun_position(make_site_at(90), {2025, 6, 21}, 0);
    const SunPosition evening =
        sun_position(make_site_at(90), {2025, 6, 21}, 18);
    EXPECT_NEAR(morning.zenith, 90 - 23.436, tolerance);
    EXPECT_NEAR(evening.zenith, morning.zenith, tolerance);
}

TEST(SunPosition, SunNeverSetsBeyondThePolarCircleInMidsummer) {
    EXPECT_LT(sun_position(make_site_at(66.6), {2025, 6, 21}, 0).zenith, 90);
    EXPECT_GT(sun_position(make_site_at(66.6), {2025, 12, 21}, 12).zenith, 90);
}

TEST(SunPosition, SunStandsInTheNorthAtNoonInTheSouthernHemisphere) {
    const double noon = 12 + 1.8 / 60;  // the equation of time on this day
    const SunPosition sun =
        sun_position(make_site_at(-35), {2025, 6, 21}, noon);
    EXPECT_NEAR(std::remainder(sun.azimuth, 360), 0, 0.1);
    EXPECT_NEAR(sun.zenith, 35 + 23.436, tolerance);
}

TEST(SunPosition, LeapDayIsCounted) {
    const Site site = make_site_at(42);
    const double before = sun_position(site, {2024, 2, 28}, 12).zenith;
    const double leap_day = sun_position(site, {2024, 2, 29}, 12).zenith;
    const double after = sun_position(site, {2024, 3, 1}, 12).zenith;
    EXPECT_NEAR(before - leap_day, 0.377, 0.01);
    EXPECT_NEAR(leap_day - after, 0.380, 0.01);
    EXPECT_NEAR(sun_position(site, {2024, 2, 29}, 36).zenith, after, 1e-9);
}

TEST(BeamDirection, LightTravelsAwayFromTheSun) {
    const glm::dvec3 down = beam_direction({0, 123});
    EXPECT_NEAR(down.x, 0, 1e-15);
    EXPECT_NEAR(down.y, 0, 1e-15);
    EXPECT_NEAR(down.z, -1, 1e-15);

    const glm::dvec3 westward = beam_direction({90, 90});
    EXPECT_NEAR(westward.x, -1, 1e-15);
    EXPECT_NEAR(westward.y, 0, 1e-15);
    EXPECT_NEAR(westward.z, 0, 1e-15);

    const glm::dvec3 northward_and_down = beam_direction({60, 180});
    EXPECT_NEAR(northward_and_down.x, 0, 1e-15);
    EXPECT_NEAR(northward_and_down.y, std::sqrt(0.75), 1e-15);
    EXPECT_NEAR(northward_and_down.z, -0.5, 1e-15);
}

}  // namespace ideotype
