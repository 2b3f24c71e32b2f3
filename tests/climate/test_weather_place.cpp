// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_csv.hpp"

namespace ideotype {
namespace {

using ::testing::HasSubstr;

TEST(WeatherPlace, AnotherLongitudeIsAnError) {
    WeatherRequest request = made_request();
    request.site.longitude = -105;
    EXPECT_THAT(error_of(MadeCsv().text(), request),
                HasSubstr("the light comes 1 h earlier than the sun of the "
                          "site"));
    request.site.longitude = -75;
    EXPECT_THAT(error_of(MadeCsv().text(), request),
                HasSubstr("the light comes 1 h later"));
    // A difference of half an hour may come from the weather.
    request.site.longitude = -82.5;
    const auto warnings = parse_weather(MadeCsv().text(), request).warnings;
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].what, HasSubstr("0.5 h later"));
}

TEST(WeatherPlace, AWrongStampIsAnError) {
    WeatherRequest request = made_request();
    request.columns.stamp = Stamp::end;
    // A difference of half an hour may come from the weather.
    const auto warnings = parse_weather(MadeCsv().text(), request).warnings;
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].what, HasSubstr("the light comes 0.5 h earlier"));
    // Ends of hours are taken for beginnings.
    request.columns.stamp = Stamp::beginning;
    EXPECT_THAT(error_of(MadeCsv(12, {2011, 7, 1}, 1).text(), request),
                HasSubstr("1 h later"));
}

TEST(WeatherPlace, FewDaysAreNoProof) {
    WeatherRequest request = made_request();
    request.site.longitude = -105;
    const auto warnings = parse_weather(MadeCsv(3).text(), request).warnings;
    ASSERT_EQ(warnings.size(), 1U);
    request.site.longitude = -125;
    EXPECT_THAT(error_of(MadeCsv(3).text(), request), HasSubstr("h earlier"));
}

TEST(WeatherPlace, TheOtherHemisphereIsTooDark) {
    WeatherRequest request = made_request();
    request.site.latitude = -50;
    EXPECT_THAT(error_of(MadeCsv().text(), request),
                HasSubstr("more light than the sun of the site outside the "
                          "atmosphere"));
}

TEST(WeatherPlace, LightThatDoesNotFollowTheSunIsAnError) {
    MadeCsv made;
    made.header = "time,x,t,ghi";
    EXPECT_THAT(error_of(made.text(),
                         [] {
                             WeatherRequest request = made_request();
                             request.columns.humidity.reset();
                             return request;
                         }()),
                HasSubstr("the light hardly follows the sun"));
}

TEST(WeatherPlace, LightOfTheNightIsCounted) {
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
    EXPECT_THAT(error_of(made.text(), made_request()),
                HasSubstr("of the light comes at night"));
}

TEST(WeatherPlace, APolarNightHasNoLight) {
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
