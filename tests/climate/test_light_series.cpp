// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

constexpr double par_fraction = 0.45;
const Date august{2025, 8, 7};
const Site ames{"Ames", 42.0, -93.6, -5.0};

DaySpan all_day(double step_minutes = 5) {
    return {{august}, 0, 24, step_minutes};
}

struct DailyTotal {
    Site site;
    double extraterrestrial;  //!< all solar radiation [MJ m-2]
    double par;               //!< under a clear sky [MJ m-2]
};

void PrintTo(const DailyTotal& total, std::ostream* out) {
    *out << total.site.name;
}

class ClearDayTotals : public testing::TestWithParam<DailyTotal> {};

}  // namespace

TEST_P(ClearDayTotals, DailyTotalsAgreeWithTheReference) {
    const auto& [site, expected_outside, expected_par] = GetParam();
    const LightSeries day = clear_days(site, all_day(), par_fraction);
    double outside = 0;
    for (const TimeStep& step : day.steps)
        outside += extraterrestrial_normal(august) *
                   std::cos(step.sun.zenith * degree) * step.seconds;
    const double par = day.incident() * 1e-6;
    const double deviation = (par / expected_par - 1) * 100;
    testing::Test::RecordProperty("deviation_percent",
                                  std::to_string(deviation));
    EXPECT_NEAR(outside * 1e-6, expected_outside, 0.01);
    EXPECT_LT(std::abs(deviation), 5) << "PAR " << par << " MJ m-2";
}

INSTANTIATE_TEST_SUITE_P(
    FiveSites, ClearDayTotals,
    testing::Values(DailyTotal{{"Barinas", 7.0, -70.2, -4}, 36.63, 12.1},
                    DailyTotal{
                        {"ThomasCounty", 39.35, -101.06, -5}, 37.87, 12.5},
                    DailyTotal{{"Ames", 42.0, -93.6, -5}, 37.50, 12.2},
                    DailyTotal{{"Bismarck", 46.8, -100.8, -5}, 36.67, 11.9},
                    DailyTotal{{"PeaceRiver", 56.2, -117.3, -6}, 34.50, 10.9}),
    [](const auto& test_case) { return test_case.param.site.name; });

// Expected values from pvlib 0.16.1, independent code with another solar
// position: solarposition.get_solarposition() with its defaults (NREL's
// algorithm), `zenith` without refraction; irradiance.get_extra_radiation(day
// of the year by the local calendar, solar_constant=1361.1) (Spencer);
// atmosphere.get_relative_airmass() with its defaults (Kasten and Young),
// get_absolute_airmass() at alt2pres(elevation); clearsky.ineichen() with that
// and our turbidity. Beam is dni cos(zenith), PAR 0.45 of both, summed over the
// instants of the span with the sun above the horizon, the first and the last
// with half a step.
struct PvlibDay {
    std::string name;
    Site site;
    DaySpan span;
    double par;   //!< [MJ m-2]
    double beam;  //!< part of it in the beam [MJ m-2]
};

void PrintTo(const PvlibDay& day, std::ostream* out) {
    *out << day.name;
}

class PvlibDays : public testing::TestWithParam<PvlibDay> {};

TEST_P(PvlibDays, DailyTotalsAgreeWithPvlibToATenThousandth) {
    const PvlibDay& expected = GetParam();
    const LightSeries day =
        clear_days(expected.site, expected.span, par_fraction);
    EXPECT_NEAR(day.incident() * 1e-6 / expected.par, 1, 1e-4);
    EXPECT_NEAR(day.beam() * 1e-6 / expected.beam, 1, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    NineDays, PvlibDays,
    testing::Values(
        PvlibDay{"Barinas", {"", 7, -70.2, -4}, all_day(), 12.04315, 10.48569},
        PvlibDay{"ThomasCounty",
                 {"", 39.35, -101.06, -5},
                 all_day(),
                 12.27862,
                 10.61664},
        PvlibDay{"Ames", {"", 42, -93.6, -5}, all_day(), 12.11069, 10.45037},
        PvlibDay{
            "Bismarck", {"", 46.8, -100.8, -5}, all_day(), 11.73573, 10.08193},
        PvlibDay{
            "PeaceRiver", {"", 56.2, -117.3, -6}, all_day(), 10.77097, 9.13856},
        PvlibDay{"AmesQuick",
                 {"", 42, -93.6, -5},
                 {{august}, 7, 20, 30},
                 12.07745,
                 10.43282},
        PvlibDay{"Mountain",
                 {"", 39.35, -101.06, -5, 2000, 2},
                 all_day(),
                 14.28411,
                 13.22382},
        PvlibDay{"HazyWinter",
                 {"", 42, -93.6, -6, 300, 4},
                 {{{2025, 12, 21}}, 0, 24, 5},
                 2.88135,
                 2.01736},
        PvlibDay{"SouthernAutumn",
                 {"", -33, 151, 10, 100, 5},
                 {{{2025, 3, 21}}, 0, 24, 5},
                 8.85476,
                 6.55184}),
    [](const auto& test_case) { return test_case.param.name; });

TEST(ClearDay, EndsOfTheDayHaveHalfWeight) {
    const LightSeries day =
        clear_days(ames, {{august}, 7, 20, 60}, par_fraction);
    ASSERT_EQ(day.steps.size(), 14u);
    EXPECT_EQ(day.steps.front().hour, 7);
    EXPECT_EQ(day.steps.front().seconds, 1800);
    EXPECT_EQ(day.steps[1].hour, 8);
    EXPECT_EQ(day.steps[1].seconds, 3600);
    EXPECT_EQ(day.steps.back().hour, 20);
    EXPECT_EQ(day.steps.back().seconds, 1800);
}

TEST(ClearDay, TotalsWeightEachInstantByItsDuration) {
    const LightSeries day =
        clear_days(ames, {{august}, 7, 20, 60}, par_fraction);
    double beam = 0;
    double diffuse = 0;
    for (const TimeStep& step : day.steps) {
        beam += step.par.beam * step.seconds;
        diffuse += step.par.diffuse * step.seconds;
        const Irradiance solar = clear_sky(ames, august, step.sun);
        EXPECT_DOUBLE_EQ(step.par.beam, par_fraction * solar.beam);
        EXPECT_DOUBLE_EQ(step.par.diffuse, par_fraction * solar.diffuse);
    }
    EXPECT_DOUBLE_EQ(day.beam(), beam);
    EXPECT_DOUBLE_EQ(day.diffuse(), diffuse);
    EXPECT_DOUBLE_EQ(day.incident(), beam + diffuse);
}

TEST(ClearDay, HourlyStepsAreCloseToTheIntegral) {
    const double hourly =
        clear_days(ames, all_day(60), par_fraction).incident();
    const double fine = clear_days(ames, all_day(1), par_fraction).incident();
    EXPECT_NEAR(hourly / fine, 1, 0.003);
}

TEST(ClearDay, HoursBelowTheHorizonAreOmitted) {
    const LightSeries whole = clear_days(ames, all_day(60), par_fraction);
    const LightSeries daylight =
        clear_days(ames, {{august}, 5, 22, 60}, par_fraction);
    ASSERT_FALSE(whole.steps.empty());
    EXPECT_LT(whole.steps.size(), 16u);
    for (const TimeStep& step : whole.steps) {
        EXPECT_LT(step.sun.zenith, 90);
        EXPECT_GT(step.par.beam + step.par.diffuse, 0);
    }
    EXPECT_EQ(whole.incident(), daylight.incident());
    EXPECT_TRUE(
        clear_days(ames, {{august}, 0, 4, 30}, par_fraction).steps.empty());
}

TEST(ClearDay, PolarNightIsEmptyAndPolarDayIsFull) {
    const Site north{"north", 78.0, 15.0, 1.0};
    const LightSeries night =
        clear_days(north, {{{2025, 12, 21}}, 0, 24, 60}, par_fraction);
    EXPECT_TRUE(night.steps.empty());
    EXPECT_EQ(night.incident(), 0);
    const LightSeries day =
        clear_days(north, {{{2025, 6, 21}}, 0, 24, 60}, par_fraction);
    EXPECT_EQ(day.steps.size(), 25u);
}

TEST(ClearDay, TotalsArePlausibleAtAllLatitudesAndOnALeapDay) {
    for (const double latitude : {-90.0, -66.6, -42.0, 0.0, 66.6, 90.0})
        for (const Date& date :
             {Date{2024, 2, 29}, {2025, 6, 21}, {2025, 12, 21}}) {
            const Site site{"somewhere", latitude, 0.0, 0.0};
            const double incident =
                clear_days(site, {{date}, 0, 24, 30}, par_fraction).incident();
            ASSERT_TRUE(std::isfinite(incident)) << latitude;
            EXPECT_GE(incident, 0) << latitude;
            EXPECT_LT(incident, 17e6) << latitude;
        }
}

TEST(ClearDay, SunriseBetweenStepsCostsLessThanOnePercent) {
    const LightSeries fine = clear_days(ames, all_day(1), par_fraction);
    const LightSeries hourly = clear_days(ames, all_day(60), par_fraction);
    EXPECT_NEAR(hourly.incident() / fine.incident(), 1, 0.01);
}

TEST(ClearDay, StepThatDoesNotDivideTheSpanIsRefused) {
    EXPECT_THROW(clear_days(ames, {{august}, 7, 20, 50}, par_fraction), Error);
    EXPECT_THROW(clear_days(ames, {{august}, 20, 7, 60}, par_fraction), Error);
    EXPECT_THROW(clear_days(ames, {{august}, 7, 20, 0}, par_fraction), Error);
}

}  // namespace ideotype
