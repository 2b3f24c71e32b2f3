// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_csv.hpp"

namespace ideotype {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(WeatherPlace, WrongLongitudeIsAnError) {
    WeatherRequest request = made_request();
    request.site.longitude = -105;
    EXPECT_THAT(parse_error(MadeCsv().text(), request),
                HasSubstr("the light comes 1 h earlier than the sun of the "
                          "site"));
    // A difference of 1 h cannot come from the time stamps: no part of an hour
    // is 1 h from its middle.
    EXPECT_THAT(parse_error(MadeCsv().text(), request),
                HasSubstr("; check the place, the clock, and the part of a "
                          "step that the times of the file mark (stamp)"));
    request.site.longitude = -75;
    EXPECT_THAT(parse_error(MadeCsv().text(), request),
                HasSubstr("the light comes 1 h later"));
    // A difference of half an hour may come from the weather.
    request.site.longitude = -82.5;
    const auto warnings = parse_weather(MadeCsv().text(), request).warnings;
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].what, HasSubstr("0.5 h later"));
}

TEST(WeatherPlace, WrongStampIsAnError) {
    WeatherRequest request = made_request();
    request.columns.stamp = Stamp::end;
    // A difference of half an hour may come from the weather.
    const auto warnings = parse_weather(MadeCsv().text(), request).warnings;
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].what, HasSubstr("the light comes 0.5 h earlier"));
    EXPECT_THAT(warnings[0].what, HasSubstr("; set stamp = \"middle\" if "));
    // The stamps are ends of hours, but are read as beginnings.
    request.columns.stamp = Stamp::beginning;
    EXPECT_THAT(parse_error(MadeCsv(12, {2011, 7, 1}, 1).text(), request),
                AllOf(HasSubstr("1 h later"), HasSubstr("stamp = \"end\"")));
}

TEST(WeatherPlace, ShortPeriodsAreCheckedLessStrictly) {
    WeatherRequest request = made_request();
    request.site.longitude = -105;
    const auto warnings = parse_weather(MadeCsv(3).text(), request).warnings;
    ASSERT_EQ(warnings.size(), 1U);
    request.site.longitude = -125;
    EXPECT_THAT(parse_error(MadeCsv(3).text(), request),
                HasSubstr("h earlier"));
}

TEST(WeatherPlace, OtherHemisphereIsTooDark) {
    WeatherRequest request = made_request();
    request.site.latitude = -50;
    EXPECT_THAT(parse_error(MadeCsv().text(), request),
                HasSubstr("more light than arrives outside the atmosphere "
                          "at this site"));
}

//! Parses several days on which the light is a constant fraction of the
//! extraterrestrial light.
Weather parse_with_clearness(double clearness, int days) {
    MadeCsv made(days);
    for (std::size_t i = 0; i < made.rows.size(); ++i)
        made.rows[i] = fmt::format(
            "{},{:.6f},20,60", made.time(static_cast<double>(i) + .5),
            2 * clearness * made.global(static_cast<int>(i)));
    return parse_weather(made.text(), made_request());
}

TEST(WeatherPlace, LightInAWrongUnitIsAnErrorInBothDirections) {
    // 1 MJ m-2 in one hour is a mean of 277.8 W m-2.
    MadeCsv made;
    for (std::size_t i = 0; i < made.rows.size(); ++i)
        made.rows[i] = fmt::format(
            "{},{:.6f},20,60", made.time(static_cast<double>(i) + .5),
            made.global(static_cast<int>(i)) * 3600 / 1e6);
    WeatherRequest request = made_request();
    request.columns.global->unit = "MJ/m2";
    EXPECT_TRUE(parse_weather(made.text(), request).warnings.empty());
    EXPECT_THAT(
        parse_error(made.text(), made_request()),
        HasSubstr("the brightest of 12 days has 0.0018 of the "
                  "light outside the atmosphere (clouds transmit 0.02 or "
                  "more); check the unit"));
    request.columns.global->unit = "kWh/m2";
    EXPECT_THAT(parse_error(made.text(), request), HasSubstr("check the unit"));
    EXPECT_THAT(parse_error(MadeCsv().text(), request),
                HasSubstr("check the unit"));
}

TEST(WeatherPlace, ImplausiblyDarkPeriodsCauseAWarning) {
    // A single very dark day is accepted; a whole month of them is not.
    EXPECT_TRUE(parse_with_clearness(.06, 1).warnings.empty());
    EXPECT_TRUE(parse_with_clearness(.2, 10).warnings.empty());
    EXPECT_TRUE(parse_with_clearness(.45, 31).warnings.empty());
    for (const auto& [clearness, days] :
         {std::pair(.03, 1), std::pair(.12, 10), std::pair(.30, 31)}) {
        const auto warnings = parse_with_clearness(clearness, days).warnings;
        ASSERT_EQ(warnings.size(), 1U) << clearness;
        EXPECT_THAT(warnings[0].what,
                    HasSubstr("(even the darkest climates have brighter "
                              "days); check the unit"));
    }
    EXPECT_THROW(parse_with_clearness(.01, 1), InputError);
}

TEST(WeatherPlace, LightThatDoesNotFollowTheSunIsAnError) {
    MadeCsv made;
    made.header = "time,x,t,ghi";
    EXPECT_THAT(parse_error(made.text(),
                            [] {
                                WeatherRequest request = made_request();
                                request.columns.humidity.reset();
                                return request;
                            }()),
                HasSubstr("the light hardly follows the sun"));
}

TEST(WeatherPlace, LightAtNightIsCounted) {
    MadeCsv made;
    made.rows[24] = made.time(24.5) + ",12,20,60";
    const Weather reading = parse_weather(made.text(), made_request());
    ASSERT_EQ(reading.warnings.size(), 1U);
    EXPECT_EQ(to_string(reading.warnings[0]),
              "made.csv:26:1: a step of the night has light, which counts as "
              "diffuse (1 time)");
    EXPECT_NEAR(reading.series.steps[24].par.diffuse, .45 * 12, 1e-12);
    EXPECT_EQ(reading.series.steps[24].par.beam, 0);
    for (std::size_t day = 1; day < 12; ++day)
        made.rows[24 * day] = made.time(24.0 * double(day) + .5) + ",90,20,60";
    EXPECT_THAT(parse_error(made.text(), made_request()),
                HasSubstr("of the light comes at night"));
}

TEST(WeatherPlace, PolarNightWithoutLightCausesAWarning) {
    MadeCsv made(12, {2011, 12, 15});
    for (std::size_t i = 0; i < made.rows.size(); ++i)
        made.rows[i] = made.time(double(i) + .5) + ",0,-20,80";
    WeatherRequest request = made_request();
    request.site.latitude = 78;
    const Weather reading = parse_weather(made.text(), request);
    EXPECT_EQ(reading.series.incident(), 0);
    ASSERT_EQ(reading.warnings.size(), 1U);
    EXPECT_THAT(reading.warnings[0].what, HasSubstr("no light at all"));
}

}  // namespace
}  // namespace ideotype
