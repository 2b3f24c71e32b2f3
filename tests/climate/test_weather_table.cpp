// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ideotype/core/units.hpp"
#include "made_csv.hpp"

namespace ideotype {
namespace {

using ::testing::HasSubstr;

Weather parse(const MadeCsv& made, const WeatherRequest& request) {
    return parse_weather(made.text(), request);
}

//! Expects that two weather series are equal within rounding.
void expect_same(const Weather& a, const Weather& b) {
    ASSERT_EQ(a.series.steps.size(), b.series.steps.size());
    for (std::size_t i = 0; i < a.series.steps.size(); ++i) {
        const TimeStep &x = a.series.steps[i], &y = b.series.steps[i];
        EXPECT_EQ(x.date.day, y.date.day);
        EXPECT_NEAR(x.hour, y.hour, 1e-9);
        EXPECT_NEAR(x.par.beam, y.par.beam, 1e-3);
        EXPECT_NEAR(x.par.diffuse, y.par.diffuse, 1e-3);
        EXPECT_NEAR(*x.temperature, *y.temperature, 1e-9);
        EXPECT_NEAR(*x.humidity, *y.humidity, 1e-9);
    }
}

TEST(WeatherTable, StampsMayMarkAnyPartOfTheHour) {
    const Weather middle = parse(MadeCsv(), made_request());
    EXPECT_EQ(middle.series.steps.size(), 12U * 24);
    EXPECT_EQ(middle.series.steps[0].hour, .5);
    EXPECT_EQ(middle.series.steps[0].temperature, 20.5);
    EXPECT_EQ(middle.series.steps[0].humidity, .6);
    WeatherRequest request = made_request();
    request.columns.stamp = Stamp::beginning;
    expect_same(parse(MadeCsv(12, {2011, 7, 1}, 0), request), middle);
    request.columns.stamp = Stamp::end;
    expect_same(parse(MadeCsv(12, {2011, 7, 1}, 1), request), middle);
}

TEST(WeatherTable, TimesInAllFormatsAreParsed) {
    const Weather plain = parse(MadeCsv(), made_request());
    const auto written = [](const std::string& header,
                            const std::vector<std::string>& names,
                            const auto& make_stamp, DateOrder order) {
        MadeCsv made;
        made.header = header + ",ghi,t,rh";
        for (int i = 0; i < 24 * 12; ++i)
            made.rows[static_cast<std::size_t>(i)] =
                fmt::format("{},{:.6f},20.5,60", make_stamp(1 + i / 24, i % 24),
                            made.global(i));
        WeatherRequest request = made_request();
        request.columns.time = names;
        request.columns.date_order = order;
        return parse(made, request);
    };
    const auto ymd = DateOrder::year_month_day;
    expect_same(plain, written(
                           "t0", {"t0"},
                           [](int day, int hour) {
                               return fmt::format("2011-07-{:02}T{:02}:30:00",
                                                  day, hour);
                           },
                           ymd));
    // The clock of the site is UTC-6.
    expect_same(plain, written(
                           "t0", {"t0"},
                           [](int day, int hour) {
                               return fmt::format(
                                   "2011-07-{:02}T{:02}:30-06:00", day, hour);
                           },
                           ymd));
    expect_same(plain, written(
                           "d,h", {"d", "h"},
                           [](int day, int hour) {
                               return fmt::format("{:02}/07/2011,{:02}30", day,
                                                  hour);
                           },
                           DateOrder::day_month_year));
    expect_same(plain, written(
                           "d,h", {"d", "h"},
                           [](int day, int hour) {
                               return fmt::format("7/{}/2011,{}:30", day, hour);
                           },
                           DateOrder::month_day_year));
    expect_same(plain, written(
                           "y,m,d,h,min", {"y", "m", "d", "h", "min"},
                           [](int day, int hour) {
                               return fmt::format("2011,7,{},{},30", day, hour);
                           },
                           ymd));
}

TEST(WeatherTable, SummerTimeInStampsIsRemoved) {
    MadeCsv made;
    for (std::size_t i = 0; i < made.rows.size(); ++i) {
        const int hour = static_cast<int>(i);
        const bool summer = i >= 100;
        made.rows[i] = fmt::format(
            "{}{},{:.6f},20.5,60", made.time(hour + .5 + (summer ? 1 : 0)),
            summer ? "-05:00" : "-06:00", made.global(hour));
    }
    expect_same(parse(made, made_request()), parse(MadeCsv(), made_request()));
}

TEST(WeatherTable, FilesInUtcUseDaysOfTheSite) {
    const MadeCsv made(12, {2011, 7, 1}, 6.5);
    WeatherRequest request = made_request();
    request.columns.utc_offset = 0;
    const Weather weather = parse(made, request);
    EXPECT_EQ(weather.series.utc_offset, -6);
    expect_same(weather, parse(MadeCsv(), made_request()));
}

TEST(WeatherTable, PeriodsOfAFileAreThoseOfSeparateReadings) {
    const std::string text = MadeCsv(20).text();
    const WeatherFile file(text, made_request());
    for (const Period& period : {Period{{2011, 7, 2}, {2011, 7, 9}},
                                 Period{{2011, 7, 10}, {2011, 7, 20}}}) {
        WeatherRequest request = made_request();
        request.period = period;
        const Weather weather = file.parse(period);
        expect_same(weather, parse_weather(text, request));
        EXPECT_EQ(weather.series.steps.front().date.day, period.from.day);
        EXPECT_EQ(weather.series.days, period.to.day - period.from.day + 1);
    }
    EXPECT_THROW(file.parse(Period{{2012, 7, 2}, {2012, 7, 9}}), InputError);
}

TEST(WeatherTable, UnitsAreConverted) {
    const Weather plain = parse(MadeCsv(), made_request());
    const auto parse_in = [](const std::string& unit, double factor) {
        MadeCsv made;
        for (std::size_t i = 0; i < made.rows.size(); ++i) {
            const int hour = static_cast<int>(i);
            made.rows[i] =
                fmt::format("{},{:.9f},{},{}", made.time(hour + .5),
                            factor * made.global(hour), 20.5 + 273.15, .6);
        }
        WeatherRequest request = made_request();
        request.columns.global->unit = unit;
        request.columns.temperature->unit = "K";
        request.columns.humidity->unit = "1";
        return parse(made, request);
    };
    expect_same(plain, parse_in("W/m^2", 1));
    expect_same(plain, parse_in("Wh/m2", 1));
    expect_same(plain, parse_in("kJ m-2", 3.6));
    expect_same(plain, parse_in("MJ/m2", .0036));
    expect_same(plain, parse_in("umol m-2 s-1", .45 * mol_per_mj_par));
    expect_same(plain,
                parse_in("\xC2\xB5mol/m\xC2\xB2/s", .45 * mol_per_mj_par));
}

TEST(WeatherTable, StepsMayBeHalfHours) {
    MadeCsv made(0);
    for (int i = 0; i < 48 * 10; ++i)
        made.rows.push_back(fmt::format(
            "{},{},20.5,60", made.time(i / 2.0 + .25), made.global(i / 2)));
    const Weather weather = parse(made, made_request());
    EXPECT_EQ(weather.series.steps.size(), 48U * 10);
    EXPECT_EQ(weather.series.steps[1].seconds, 1800);
    EXPECT_EQ(weather.series.steps[1].hour, .75);
}

TEST(WeatherTable, GivenPartsOfTheLightAreUsed) {
    // Returns the time step at noon.
    const auto with = [](const std::string& parts, auto&& set) {
        MadeCsv made;
        made.header = "time,ghi,t,rh,x,y";
        for (std::string& row : made.rows) row += "," + parts;
        WeatherRequest request = made_request();
        set(request.columns);
        return parse(made, request).series.steps[12];
    };
    const TimeStep fraction = with("0.25,", [](ColumnMap& columns) {
        columns.diffuse_fraction = Column{"x", "1"};
    });
    const double global = .45 * MadeCsv().global(12);
    EXPECT_NEAR(fraction.par.diffuse, global / 4, 1e-5);
    EXPECT_NEAR(fraction.par.beam, global * 3 / 4, 1e-5);
    const TimeStep diffuse = with("100,", [](ColumnMap& columns) {
        columns.diffuse = Column{"x", "W/m2"};
    });
    EXPECT_NEAR(diffuse.par.diffuse, 45, 1e-9);
    EXPECT_NEAR(diffuse.par.beam, global - 45, 1e-5);
    const double cosine = std::cos(diffuse.sun.zenith * degree);
    const TimeStep normal = with("500,", [](ColumnMap& columns) {
        columns.beam_normal = Column{"x", "W/m2"};
    });
    EXPECT_NEAR(normal.par.beam, 225 * cosine, 1e-5);
    EXPECT_NEAR(normal.par.diffuse, global - 225 * cosine, 1e-5);
    // If values of a column are unknown, the column is ignored.
    const TimeStep erbs = with("-999,", [](ColumnMap& columns) {
        columns.diffuse = Column{"x", "W/m2"};
    });
    EXPECT_NEAR(erbs.par.beam, with(",", [](ColumnMap&) {}).par.beam, 1e-12);
    EXPECT_GT(erbs.par.beam, .2 * global);
}

TEST(WeatherTable, BeamAndDiffuseLightAreSufficient) {
    MadeCsv made;
    made.header = "time,diffuse,beam";
    for (std::size_t i = 0; i < made.rows.size(); ++i) {
        const double light = made.global(static_cast<int>(i));
        made.rows[i] = fmt::format("{},{},{}", made.time(double(i) + .5),
                                   light / 2, light > 0 ? 300 : 0);
    }
    WeatherRequest request = made_request();
    request.columns = ColumnMap{};
    request.columns.time = {"time"};
    request.columns.stamp = Stamp::middle;
    request.columns.diffuse = Column{"diffuse", "W/m2"};
    EXPECT_THAT(parse_error(made.text(), request),
                HasSubstr("no column contains the light"));
    request.columns.beam_normal = Column{"beam", "W/m2"};
    const TimeStep noon = parse(made, request).series.steps[12];
    EXPECT_NEAR(noon.par.beam, .45 * 300 * std::cos(noon.sun.zenith * degree),
                1e-9);
    EXPECT_FALSE(noon.temperature);
    EXPECT_FALSE(noon.humidity);
}

TEST(WeatherTable, ColumnsOfTheConverterNeedNoMapping) {
    MadeCsv made;
    const Weather mapped = parse(made, made_request());
    made.header = "# a remark, with a comma\ntime,global,temperature,humidity";
    const WeatherRequest request{"made.csv", middle_west};
    expect_same(parse(made, request), mapped);
    for (std::string& row : made.rows) row.insert(16, ":00-06:00");
    expect_same(parse(made, request), mapped);
    WeatherRequest beginning = request;
    beginning.columns.stamp = Stamp::beginning;
    EXPECT_EQ(parse(made, beginning).series.steps[0].hour, 1);
    // Unknown values are empty cells.
    made.rows[0].resize(made.rows[0].rfind(',') + 1);
    EXPECT_EQ(parse(made, request).warnings.size(), 1U);
    made.header = "time,diffuse,beam_normal,humidity";
    EXPECT_EQ(parse_error(made.text(), request)
                  .find("the light hardly follows the sun"),
              std::string::npos);
}

}  // namespace
}  // namespace ideotype
