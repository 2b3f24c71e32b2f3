// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_csv.hpp"

namespace ideotype {
namespace {

using ::testing::HasSubstr;

//! Returns the error message for a table after the given change.
template <class Change>
std::string parse_changed(Change&& change) {
    MadeCsv made;
    change(made);
    return parse_error(made.text(), made_request());
}

//! Replaces the light of a row.
void set_light(MadeCsv& made, int row, const std::string& light) {
    made.rows[static_cast<std::size_t>(row)] =
        made.time(row + .5) + "," + light + ",20.5,60";
}

constexpr int noon = 36, midnight = 24;  //!< numbers of rows

TEST(WeatherProblems, MissingLightByDayIsAnError) {
    for (const char* missing : {"-999", "-9999", "9999", "NaN", "NA", ""})
        EXPECT_THAT(
            parse_changed(
                [&](MadeCsv& made) { set_light(made, noon, missing); }),
            HasSubstr("made.csv:38:1: the light of 2011-07-02 12:30 is not "
                      "known"))
            << missing;
    // Consecutive hours without light are reported as one gap.
    const std::string several = parse_changed([](MadeCsv& made) {
        for (int i = noon; i < noon + 3; ++i) set_light(made, i, "-999");
    });
    EXPECT_EQ(std::count(several.begin(), several.end(), '\n'), 0);
}

TEST(WeatherProblems, GapsByDayAreReportedAtTheLineBefore) {
    const auto erase = [](MadeCsv& made) {
        made.rows.erase(made.rows.begin() + noon, made.rows.begin() + noon + 2);
    };
    EXPECT_THAT(parse_changed(erase),
                HasSubstr("made.csv:37:1: the light of 2011-07-02 12:30"));
}

TEST(WeatherProblems, GapsAtNightAreFilledAndCounted) {
    MadeCsv made;
    made.rows.erase(made.rows.begin() + midnight,
                    made.rows.begin() + midnight + 2);
    const Weather reading = parse_weather(made.text(), made_request());
    EXPECT_EQ(reading.series.steps.size(), 12U * 24);
    EXPECT_EQ(reading.series.steps[midnight].par.diffuse, 0);
    EXPECT_EQ(reading.series.steps[midnight].temperature, 20.5);
    ASSERT_EQ(reading.warnings.size(), 3U);
    EXPECT_EQ(to_string(reading.warnings[0]),
              "made.csv:25:1: a value of the temperature is not known and is "
              "interpolated (2 times)");
    EXPECT_EQ(to_string(reading.warnings[2]),
              "made.csv:25:1: a step of the night has no light in the file; it "
              "counts as 0 (2 times)");
}

TEST(WeatherProblems, TemperatureIsInterpolatedOverUpToSixHours) {
    MadeCsv made;
    const auto lose = [&](int first, int count) {
        for (int i = first; i < first + count; ++i)
            made.rows[static_cast<std::size_t>(i)] =
                fmt::format("{},{},-999,60", made.time(i + .5), made.global(i));
    };
    lose(noon, 3);
    made.rows[noon + 3] = fmt::format("{},{},24.5,60", made.time(noon + 3.5),
                                      made.global(noon + 3));
    const Weather reading = parse_weather(made.text(), made_request());
    EXPECT_NEAR(*reading.series.steps[noon].temperature, 21.5, 1e-12);
    EXPECT_NEAR(*reading.series.steps[noon + 2].temperature, 23.5, 1e-12);
    ASSERT_EQ(reading.warnings.size(), 1U);
    EXPECT_EQ(reading.warnings[0].where.line, MadeCsv::line(noon));
    lose(noon, 7);
    EXPECT_THAT(parse_error(made.text(), made_request()),
                HasSubstr("made.csv:38:1: the temperature is not known for 7 "
                          "hours"));
}

TEST(WeatherProblems, WrongOrderAndDuplicatesAreErrors) {
    EXPECT_THAT(parse_changed([](MadeCsv& made) {
                    std::swap(made.rows[40], made.rows[41]);
                }),
                HasSubstr("made.csv:43:1: the time is before that of line 42"));
    EXPECT_THAT(parse_changed([](MadeCsv& made) {
                    made.rows.insert(made.rows.begin() + 41, made.rows[40]);
                }),
                HasSubstr("made.csv:43:1: the same time as on line 42"));
    EXPECT_THAT(
        parse_changed([](MadeCsv& made) {
            made.rows.insert(made.rows.begin() + 41, made.row(40, .75));
        }),
        HasSubstr("made.csv:43:1: the time is not a whole number of steps"));
}

TEST(WeatherProblems, NegativeLightIsCountedOrAnError) {
    MadeCsv made;
    set_light(made, midnight, "-3");
    set_light(made, midnight + 1, "-2");
    const Weather reading = parse_weather(made.text(), made_request());
    EXPECT_EQ(reading.series.steps[midnight].par.diffuse, 0);
    ASSERT_EQ(reading.warnings.size(), 1U);
    EXPECT_EQ(to_string(reading.warnings[0]),
              "made.csv:26:1: a value of light is slightly negative; it counts "
              "as 0 (2 times)");
    EXPECT_THAT(
        parse_changed([](MadeCsv& csv) { set_light(csv, midnight, "-50"); }),
        HasSubstr("made.csv:26:18: -50 means -50 W m-2 (outside -20 to 2000)"));
}

TEST(WeatherProblems, ContradictoryPartsOfLightAreCounted) {
    MadeCsv made;
    made.header += ",dhi,dni";
    for (std::size_t i = 0; i < made.rows.size(); ++i)
        made.rows[i] +=
            fmt::format(",{},100", made.global(static_cast<int>(i)));
    WeatherRequest request = made_request();
    request.columns.diffuse = Column{"dhi", "W/m2"};
    // Diffuse light already equals global light, so that the whole beam is an
    // excess: about 100 of 680 W m-2.
    request.columns.beam_normal = Column{"dni", "W/m2"};
    const auto closure = parse_weather(made.text(), request).warnings;
    ASSERT_EQ(closure.size(), 1U);
    EXPECT_THAT(closure[0].what,
                HasSubstr("beam and diffuse light sum to 115 % of the global"));
    request.columns.beam_normal.reset();
    made.rows[noon] = made.time(noon + .5) + ",400,20,60,600,0";
    const auto diffuse = parse_weather(made.text(), request).warnings;
    ASSERT_EQ(diffuse.size(), 1U);
    EXPECT_THAT(diffuse[0].what,
                HasSubstr("more diffuse than global light, all of which counts "
                          "as diffuse (1 time)"));
    made.rows[noon] = made.time(noon + .5) + ",1900,20,60,100,0";
    const Weather capped = parse_weather(made.text(), request);
    ASSERT_EQ(capped.warnings.size(), 1U);
    EXPECT_THAT(capped.warnings[0].what,
                HasSubstr("more beam than there is outside the atmosphere"));
    const TimeStep& light = capped.series.steps[noon];
    EXPECT_NEAR(light.par.beam + light.par.diffuse, .45 * 1900, 1e-9);
    EXPECT_NEAR(light.par.beam, .45 * 2 * made.global(noon), .05);
}

TEST(WeatherProblems, MalformedNumbersAndDatesAreErrors) {
    EXPECT_THAT(parse_changed([](MadeCsv& made) { set_light(made, 5, "x1"); }),
                HasSubstr("made.csv:7:18: \"x1\" is not a number; correct "
                          "it"));
    EXPECT_THAT(
        parse_changed([](MadeCsv& made) { set_light(made, 5, "5000"); }),
        HasSubstr("check the unit"));
    EXPECT_THAT(
        parse_changed([](MadeCsv& made) { made.rows[5] = "2011-02-30"; }),
        HasSubstr("made.csv:7:1: \"2011-02-30\" is not a date and time"));
    EXPECT_THAT(parse_changed(
                    [](MadeCsv& made) { made.rows[5] = "2011-257-02 12:30"; }),
                HasSubstr("is not a date and time"));
    // Gaps of centuries are not filled.
    EXPECT_THAT(parse_changed([](MadeCsv& made) {
                    made.rows.push_back("9999-07-02 12:30,0,20,60");
                }),
                HasSubstr("the file has only 289 of the"));
    // Problems of one kind are reported once with their count; problems of
    // other kinds are listed with their lines.
    EXPECT_EQ(parse_changed([](MadeCsv& made) {
                  for (int i = 0; i < 50; ++i) set_light(made, i, "x");
                  made.rows[50] = made.time(50.5) + ",5000,x,60";
              }),
              "made.csv:2:18: \"x\" is not a number; correct it, or leave the "
              "entry empty (this line and 49 others)\n"
              "made.csv:52:18: 5000 means 5000 W m-2 (outside -20 to 2000); "
              "check the unit, or the code of missing values\n"
              "made.csv:52:23: \"x\" is not a number; correct it, or leave the "
              "entry empty");
    // In a row that is too short, the light is missing.
    EXPECT_THAT(parse_changed([](MadeCsv& made) {
                    made.rows[noon] = made.time(noon + .5);
                }),
                HasSubstr("12:30 is not known"));
}

TEST(WeatherProblems, UnknownColumnsAndUnitsAreNamed) {
    WeatherRequest request = made_request();
    request.columns.global->name = "ghj";
    EXPECT_THAT(
        parse_error(MadeCsv().text(), request),
        HasSubstr("made.csv:1:1: there is no column \"ghj\"; is it \"ghi\"?"));
    request = made_request();
    request.columns.global->unit = "W/ft2";
    EXPECT_THAT(parse_error(MadeCsv().text(), request),
                HasSubstr("\"W/ft2\" is not a unit for the column \"ghi\"; use "
                          "one of W/m2, kW/m2, Wh/m2"));
    request.columns.time = {"when"};
    EXPECT_THAT(parse_error(MadeCsv().text(), request),
                HasSubstr("no line has a column \"when\""));
    EXPECT_THAT(parse_error("", WeatherRequest{"x", middle_west}),
                HasSubstr("ideotype weather"));
    EXPECT_THAT(parse_error("time,ghi,t,rh\n", made_request()),
                HasSubstr("there are fewer than two rows"));
    MadeCsv twice;
    twice.header = "time,ghi,ghi,rh,t";
    EXPECT_THAT(parse_error(twice.text(), made_request()),
                HasSubstr("two columns have the name \"ghi\""));
}

TEST(WeatherProblems, WindPressureAndLongwaveHaveUnits) {
    MadeCsv csv;
    csv.header += ",u,p,l";
    for (std::string& row : csv.rows) row += ",18,990,1.08";
    csv.rows[4].replace(csv.rows[4].rfind(",18,"), 4, ",NA,");
    WeatherRequest request = made_request();
    request.columns.wind = Column{"u", "km/h"};
    request.columns.pressure = Column{"p", "hPa"};
    request.columns.longwave = Column{"l", "MJ/m2"};
    const Weather weather = parse_weather(csv.text(), request);
    for (const TimeStep& step : weather.series.steps) {
        EXPECT_DOUBLE_EQ(step.wind.value(), 5);
        EXPECT_DOUBLE_EQ(step.pressure.value(), 99);
        EXPECT_DOUBLE_EQ(step.longwave.value(), 300);
    }
    EXPECT_EQ(weather.warnings.size(), 1U);
    request.columns.pressure->unit = "kPa";
    EXPECT_NE(
        parse_error(csv.text(), request).find("990 means 990 kPa (outside"),
        std::string::npos);
    request.columns.pressure->unit = "hPa";
    request.columns.longwave->unit = "umol/m2/s";
    EXPECT_NE(
        parse_error(csv.text(), request).find("is not a unit for the column"),
        std::string::npos);
}

TEST(WeatherProblems, OtherFormatsAreReferredToTheConverter) {
    WeatherRequest request{"weather/mine.epw", middle_west};
    const std::string text = "LOCATION,a,b,c,d,1,42,-90,-6,300\n2011,7,1\n";
    EXPECT_EQ(parse_error(text, request),
              "weather/mine.epw:1:1: this is not a table with columns time and "
              "global; map its columns in [[climate]], or convert it and name "
              "the file that this command writes: ideotype weather "
              "'weather/mine.epw' --to "
              "'weather/mine_weather.csv' --latitude 42 --longitude -90 "
              "--utc-offset -6");
    request.period = Period{{2011, 7, 5}, {2011, 8, 20}};
    EXPECT_THAT(parse_error(text, request),
                HasSubstr("--from 2011-07-05 --until 2011-08-20"));
    EXPECT_THAT(parse_error("time,P,G(i)\n1,2,3\n", request),
                HasSubstr("ideotype weather"));
}

TEST(WeatherProblems, PeriodMustBeInTheFile) {
    WeatherRequest request = made_request();
    request.period = Period{{2011, 7, 5}, {2011, 7, 20}};
    EXPECT_EQ(parse_error(MadeCsv().text(), request),
              "made.csv: the file has 2011-07-01 to 2011-07-12, but the period "
              "is 2011-07-05 to 2011-07-20; choose days that it has");
    // Problems outside the requested period are ignored.
    request.period = Period{{2011, 7, 5}, {2011, 7, 9}};
    MadeCsv made;
    set_light(made, noon, "x");
    EXPECT_EQ(parse_error(made.text(), request), "");
}

TEST(WeatherProblems, ErrorsOfDatesSuggestTheRightOrder) {
    const auto reordered = [](bool month_first, int days) {
        MadeCsv made(days);
        for (std::string& row : made.rows) {
            const std::string year = row.substr(0, 4), month = row.substr(5, 2),
                              day = row.substr(8, 2);
            row = (month_first ? month + '/' + day : day + '/' + month) + '/' +
                  year + row.substr(10);
        }
        return parse_error(made.text(), made_request());
    };
    // One message stands for all rows, and names the remedy.
    EXPECT_EQ(reordered(true, 14),
              "made.csv:2:1: \"07/01/2011 00:30\" is not a date and time; set "
              "date_order = \"month_day_year\" (this line and 335 others)");
    EXPECT_THAT(reordered(false, 14), HasSubstr("\"day_month_year\""));
    // Days up to the twelfth could also be months, but then the dates would not
    // be consecutive.
    EXPECT_THAT(reordered(true, 9), HasSubstr("\"month_day_year\""));
    EXPECT_THAT(reordered(false, 9), HasSubstr("\"day_month_year\""));
    EXPECT_THAT(
        parse_changed([](MadeCsv& made) { made.rows[5] = "noon,1,2,3"; }),
        HasSubstr("made.csv:7:1: \"noon\" is not a date and time; correct "
                  "it, or check date_order and the columns of time"));
}

}  // namespace
}  // namespace ideotype
