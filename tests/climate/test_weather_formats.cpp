// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ideotype/climate/weather_reader.hpp"
#include "ideotype/core/units.hpp"
#include "made_csv.hpp"

namespace ideotype {
namespace {

using ::testing::HasSubstr;

const Site greensboro{"greensboro", 36.1, -79.95, -5, 273};

//! What pvlib reads and computes; data/weather/make.py.
struct Expected {
    Date date;
    double hour, zenith, azimuth, ghi, dni, dhi, erbs_dhi, temperature,
        humidity;
};

std::vector<Expected> expected() {
    std::ifstream file(IDEOTYPE_TEST_DATA "/weather/expected.csv");
    std::string line;
    std::getline(file, line);
    std::vector<Expected> all;
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::replace(line.begin(), line.begin() + 10, '-', ' ');
        std::istringstream text(line);
        Expected& e = all.emplace_back();
        text >> e.date.year >> e.date.month >> e.date.day >> e.hour >>
            e.zenith >> e.azimuth >> e.ghi >> e.dni >> e.dhi >> e.erbs_dhi >>
            e.temperature >> e.humidity;
    }
    return all;
}

struct File {
    std::string name;
    bool has_diffuse = true;
};

class WeatherFormat : public ::testing::TestWithParam<File> {};

TEST_P(WeatherFormat, GivesWhatPvlibReads) {
    const File file = GetParam();
    const std::vector<Expected> all = expected();
    ASSERT_EQ(all.size(), 120U);
    const WeatherReading reading =
        read_weather({IDEOTYPE_TEST_DATA "/weather/" + file.name, greensboro});
    EXPECT_TRUE(reading.warnings.empty())
        << to_string(reading.warnings.front());
    EXPECT_EQ(reading.weather.utc_offset, -5);
    ASSERT_EQ(reading.weather.series.steps.size(), all.size());
    EXPECT_EQ(reading.weather.series.days, 5);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const TimeStep& step = reading.weather.series.steps[i];
        const Expected& e = all[i];
        EXPECT_EQ(step.date.year, e.date.year);
        EXPECT_EQ(step.date.month, e.date.month);
        EXPECT_EQ(step.date.day, e.date.day);
        EXPECT_EQ(step.hour, e.hour);
        EXPECT_EQ(step.seconds, 3600);
        // Our sun is exact from 2020 on.
        EXPECT_NEAR(step.sun.zenith, e.zenith, .01);
        EXPECT_NEAR(
            (step.sun.azimuth - e.azimuth) * std::sin(e.zenith * degree), 0,
            .01);
        // Rounded to 6 digits where energies are written.
        const double global = step.par.beam + step.par.diffuse;
        EXPECT_NEAR(global, .45 * e.ghi, 1e-5 * e.ghi);
        const double sky = e.zenith > 90      ? e.ghi
                           : file.has_diffuse ? std::min(e.dhi, e.ghi)
                                              : e.erbs_dhi;
        // At low sun the cap leaves more to the diffuse light.
        if (e.zenith < 85) {
            EXPECT_NEAR(step.par.diffuse, .45 * sky, .05);
        } else {
            EXPECT_GE(step.par.diffuse, .45 * sky - .05);
        }
        EXPECT_NEAR(step.temperature.value(), e.temperature, 1e-12);
        EXPECT_NEAR(step.humidity.value(), e.humidity / 100, 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(Files, WeatherFormat,
                         ::testing::Values(File{"tmy3.csv"}, File{"small.epw"},
                                           File{"nsrdb.csv"},
                                           File{"power_utc.csv"},
                                           File{"power_lst.csv", false}),
                         [](const auto& test_case) {
                             const std::string& name = test_case.param.name;
                             return name.substr(0, name.find('.'));
                         });

TEST(Weather, BeamIsCappedAtTheExtraterrestrial) {
    WeatherRequest request{IDEOTYPE_TEST_DATA "/weather/tmy3.csv", greensboro};
    request.par_fraction = 1;
    for (const TimeStep& step : read_weather(request).weather.series.steps) {
        const double cosine = std::cos(step.sun.zenith * degree);
        EXPECT_LE(step.par.beam,
                  extraterrestrial_normal(step.date) * std::max(0.0, cosine));
        if (cosine <= 0) {
            EXPECT_EQ(step.par.beam, 0);
        }
    }
}

TEST(Weather, PeriodIsChosenFromAFile) {
    WeatherRequest request{IDEOTYPE_TEST_DATA "/weather/tmy3.csv", greensboro};
    request.period = Period{{1981, 7, 2}, {1981, 7, 3}};
    const Weather weather = read_weather(request).weather;
    EXPECT_EQ(weather.series.steps.size(), 48U);
    EXPECT_EQ(weather.series.steps.front().date.day, 2);
    EXPECT_EQ(weather.series.steps.back().hour, 23.5);
}

//! A year of TMY3 whose months are of different years.
std::string typical_year() {
    std::string text =
        "1,\"MADE, FOR A TEST\",IA,-6.0,42.0,-90.0,300\n"
        "Date (MM/DD/YYYY),Time (HH:MM),GHI (W/m^2),Dry-bulb (C),RHum "
        "(%),DNI (W/m^2),DHI (W/m^2)\n";
    for (int month = 1; month <= 12; ++month) {
        const int days = month == 2 ? 28
                         : month == 4 || month == 6 || month == 9 || month == 11
                             ? 30
                             : 31;
        const int year = 1976 + 7 * month % 12;
        for (int day = 1; day <= days; ++day) {
            const MadeCsv made(0, {year, month, day});
            for (int hour = 0; hour < 24; ++hour)
                text += fmt::format(
                    "{:02}/{:02}/{},{:02}:00,{:.3f},{},50,-9900,{:.3f}\n",
                    month, day, year, hour + 1, made.global(hour), month,
                    made.global(hour) / 2);
        }
    }
    return text;
}

TEST(Weather, TypicalYearHasTheDatesOfThePeriod) {
    WeatherRequest request{"typical.csv", middle_west};
    request.period = Period{{2023, 12, 30}, {2024, 3, 1}};
    const WeatherReading reading = parse_weather(typical_year(), request);
    const auto& steps = reading.weather.series.steps;
    // January and March of 2024, without its 29 February.
    EXPECT_EQ(reading.weather.series.days, 2 + 31 + 28 + 1);
    ASSERT_EQ(steps.size(), 24U * 62);
    EXPECT_EQ(steps[0].date.year, 2023);
    EXPECT_EQ(steps[0].temperature, 12);
    EXPECT_EQ(steps[48].date.year, 2024);
    EXPECT_EQ(steps[48].date.month, 1);
    EXPECT_EQ(steps[48].temperature, 1);
    EXPECT_EQ(steps.back().date.month, 3);
    ASSERT_EQ(reading.warnings.size(), 1U);
    EXPECT_THAT(to_string(reading.warnings[0]),
                HasSubstr("29 February is not in the file"));
    // The file's years mean nothing, without a period either.
    request.period.reset();
    EXPECT_EQ(parse_weather(typical_year(), request).weather.series.days, 365);
    request.period = Period{{2023, 1, 1}, {2024, 6, 1}};
    EXPECT_THAT(error_of(typical_year(), request), HasSubstr("longer than"));
}

TEST(Weather, EnergyPlusFilesMayHaveHalfHours) {
    std::string text =
        "LOCATION,a,b,c,d,1,42,-90,-6,300\n"
        "DATA PERIODS,1,2,Data,Friday,7/1,7/10\n";
    const MadeCsv made(0);
    for (int i = 0; i < 48 * 10; ++i)
        text += fmt::format(
            "2011,7,{},{},{},?,20,10,50,99999,9999,9999,9999,{},9999,9999\n",
            1 + i / 48, 1 + i % 48 / 2, i % 2 == 0 ? 30 : 60,
            made.global(i / 2) / 2);
    const Weather weather =
        parse_weather(text, {"half.epw", middle_west}).weather;
    ASSERT_EQ(weather.series.steps.size(), 48U * 10);
    EXPECT_EQ(weather.series.steps[0].hour, .25);
    EXPECT_EQ(weather.series.steps[24].hour, 12.25);
    EXPECT_EQ(weather.series.steps[24].date.day, 1);
    EXPECT_NEAR(weather.series.steps[24].par.beam +
                    weather.series.steps[24].par.diffuse,
                .45 * made.global(12), 1e-3);
}

TEST(Weather, SeasonOfBondvilleHasItsLight) {
    WeatherRequest request{IDEOTYPE_CAMPAIGNS
                           "/weather/bondville_2011_0721_0920.csv",
                           {"bondville", 40.05, -88.37, -6, 213}};
    ColumnMap columns;
    columns.time = {"time"};
    columns.stamp = Stamp::middle;
    columns.global = Column{"ppfd_umol", "umol/m2/s"};
    columns.diffuse_fraction = Column{"diffuse_fraction_erbs", "1"};
    columns.temperature = Column{"temp_c", "C"};
    columns.humidity = Column{"rh", "1"};
    request.columns = columns;
    const WeatherReading reading = read_weather(request);
    EXPECT_TRUE(reading.warnings.empty());
    EXPECT_EQ(reading.weather.series.days, 62);
    EXPECT_EQ(reading.weather.series.steps.size(), 62U * 24);
    // The sum of the column: 39.6742 mol m-2 d-1 of photons.
    const double photons = reading.weather.series.incident() * mol_per_mj_par /
                           joule_per_megajoule;
    EXPECT_NEAR(photons, 39.6742, 1e-4);
    // 798 hours with the sun above 2 deg and light.
    int lit = 0;
    for (const TimeStep& step : reading.weather.series.steps)
        lit += step.sun.zenith < 88 &&
               (step.par.beam + step.par.diffuse) * mol_per_mj_par > 2;
    EXPECT_EQ(lit, 798);
}

}  // namespace
}  // namespace ideotype
