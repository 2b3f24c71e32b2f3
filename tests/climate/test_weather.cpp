// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ideotype/climate/weather.hpp"
#include "ideotype/core/file.hpp"
#include "ideotype/core/units.hpp"
#include "made_csv.hpp"

namespace ideotype {
namespace {

using ::testing::HasSubstr;

const Site greensboro{"greensboro", 36.1, -79.95, -5, 273};

//! Values that pvlib reads and computes, written by data/weather/make.py.
struct Expected {
    Date date;
    double hour, zenith, azimuth, ghi, dni, dhi, erbs_dhi, temperature,
        humidity;
};

std::vector<Expected> read_expected() {
    std::ifstream file(IDEOTYPE_TEST_DATA "/weather/expected.csv");
    std::string line;
    std::getline(file, line);
    std::vector<Expected> rows;
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::replace(line.begin(), line.begin() + 10, '-', ' ');
        std::istringstream text(line);
        Expected& e = rows.emplace_back();
        text >> e.date.year >> e.date.month >> e.date.day >> e.hour >>
            e.zenith >> e.azimuth >> e.ghi >> e.dni >> e.dhi >> e.erbs_dhi >>
            e.temperature >> e.humidity;
    }
    return rows;
}

//! Writes a table in the form of `ideotype weather`.
std::string make_table(const std::vector<Expected>& rows, bool has_parts) {
    std::string text = "time,global,temperature,humidity";
    if (has_parts) text += ",beam_normal,diffuse";
    for (const Expected& e : rows) {
        text += fmt::format("\n{}T{:02}:30:00-05:00,{},{},{}",
                            to_string(e.date), static_cast<int>(e.hour), e.ghi,
                            e.temperature, e.humidity);
        if (has_parts) text += fmt::format(",{},{}", e.dni, e.dhi);
    }
    return text;
}

class WeatherLight : public ::testing::TestWithParam<bool> {};

TEST_P(WeatherLight, LightAgreesWithPvlib) {
    const std::vector<Expected> rows = read_expected();
    ASSERT_EQ(rows.size(), 120U);
    const Weather weather =
        parse_weather(make_table(rows, GetParam()), {"five.csv", greensboro});
    EXPECT_TRUE(weather.warnings.empty())
        << to_string(weather.warnings.front());
    EXPECT_EQ(weather.series.utc_offset, -5);
    ASSERT_EQ(weather.series.steps.size(), rows.size());
    EXPECT_EQ(weather.series.days, 5);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const TimeStep& step = weather.series.steps[i];
        const Expected& e = rows[i];
        EXPECT_EQ(step.date, e.date);
        EXPECT_EQ(step.hour, e.hour);
        EXPECT_EQ(step.seconds, 3600);
        // The algorithm for the position of the sun is accurate from 2020 on.
        EXPECT_NEAR(step.sun.zenith, e.zenith, .01);
        EXPECT_NEAR(
            (step.sun.azimuth - e.azimuth) * std::sin(e.zenith * degree), 0,
            .01);
        const double global = step.par.beam + step.par.diffuse;
        EXPECT_NEAR(global, .45 * e.ghi, 1e-9);
        const double sky = e.zenith > 90 ? e.ghi
                           : GetParam()  ? std::min(e.dhi, e.ghi)
                                         : e.erbs_dhi;
        // When the sun is low, the upper limit on the beam increases the
        // diffuse part.
        if (e.zenith < 85) {
            EXPECT_NEAR(step.par.diffuse, .45 * sky, .05);
        } else {
            EXPECT_GE(step.par.diffuse, .45 * sky - .05);
        }
        const double cosine = std::cos(step.sun.zenith * degree);
        EXPECT_LE(step.par.beam, .45 * extraterrestrial_normal(step.date) *
                                     std::max(0.0, cosine));
        EXPECT_NEAR(step.temperature.value(), e.temperature, 1e-12);
        EXPECT_NEAR(step.humidity.value(), e.humidity / 100, 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(WithParts, WeatherLight, ::testing::Bool());

TEST(Weather, PeriodIsSelectedFromAFile) {
    WeatherRequest request{"five.csv", greensboro};
    request.period = Period{{1981, 7, 2}, {1981, 7, 3}};
    const LightSeries series =
        parse_weather(make_table(read_expected(), true), request).series;
    EXPECT_EQ(series.steps.size(), 48U);
    EXPECT_EQ(series.steps.front().date.day, 2);
    EXPECT_EQ(series.steps.back().hour, 23.5);
}

TEST(Weather, LeapDayMayBeMissing) {
    MadeCsv made(4, {2024, 2, 26});
    made.rows.resize(24 * 3);
    const MadeCsv march(2, {2024, 3, 1});
    made.rows.insert(made.rows.end(), march.rows.begin(), march.rows.end());
    const Weather weather = parse_weather(made.text(), made_request());
    EXPECT_EQ(weather.series.days, 5);
    ASSERT_EQ(weather.warnings.size(), 1U);
    EXPECT_THAT(to_string(weather.warnings[0]),
                HasSubstr("29 February is not in the file"));
}

TEST(Weather, SeasonOfBondvilleHasItsMeasuredLight) {
    WeatherRequest request{"bondville.csv",
                           {"bondville", 40.05, -88.37, -6, 213}};
    ColumnMap& columns = request.columns;
    columns.time = {"time"};
    columns.stamp = Stamp::middle;
    columns.global = Column{"ppfd_umol", "umol/m2/s"};
    columns.diffuse_fraction = Column{"diffuse_fraction_erbs", "1"};
    columns.temperature = Column{"temp_c", "C"};
    columns.humidity = Column{"rh", "1"};
    const Weather weather = parse_weather(
        read_file(IDEOTYPE_CAMPAIGNS "/weather/bondville_2011_0721_0920.csv",
                  most_data_bytes)
            .text,
        request);
    EXPECT_TRUE(weather.warnings.empty());
    EXPECT_EQ(weather.series.days, 62);
    EXPECT_EQ(weather.series.steps.size(), 62U * 24);
    // The sum of the column is 39.6742 mol m-2 d-1 of photons.
    const double photons =
        weather.series.incident() * mol_per_mj_par / joule_per_megajoule;
    EXPECT_NEAR(photons, 39.6742, 1e-4);
    // In 798 hours the sun is above 2 deg and the light is not zero.
    int lit = 0;
    for (const TimeStep& step : weather.series.steps)
        lit += step.sun.zenith < 88 &&
               (step.par.beam + step.par.diffuse) * mol_per_mj_par > 2;
    EXPECT_EQ(lit, 798);
}

}  // namespace
}  // namespace ideotype
