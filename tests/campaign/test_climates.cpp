// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "campaign/weather_reader.hpp"
#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"
#include "spec/reader.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"
#include "temporary_folder.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

const fs::path folder = IDEOTYPE_CAMPAIGNS;

Campaign bondville() {
    return read_campaign((folder / "bondville.toml").string());
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

void expect_same(const LightSeries& a, const LightSeries& b) {
    EXPECT_EQ(a.days, b.days);
    ASSERT_EQ(a.steps.size(), b.steps.size());
    for (std::size_t i = 0; i < a.steps.size(); ++i) {
        EXPECT_EQ(a.steps[i].date, b.steps[i].date);
        EXPECT_EQ(a.steps[i].hour, b.steps[i].hour);
        EXPECT_EQ(a.steps[i].sun.zenith, b.steps[i].sun.zenith);
        EXPECT_EQ(a.steps[i].par.beam, b.steps[i].par.beam);
        EXPECT_EQ(a.steps[i].par.diffuse, b.steps[i].par.diffuse);
        EXPECT_EQ(a.steps[i].temperature, b.steps[i].temperature);
        EXPECT_EQ(a.steps[i].humidity, b.steps[i].humidity);
        EXPECT_EQ(a.steps[i].nir.beam, b.steps[i].nir.beam);
        EXPECT_EQ(a.steps[i].nir.diffuse, b.steps[i].nir.diffuse);
    }
}

}  // namespace

TEST(Climates, ASeasonIsReadFromItsFile) {
    const Campaign campaign = bondville();
    const Cases campaign_cases = cases(campaign);
    EXPECT_EQ(campaign_cases[0].name, "bondville_season_30x6_all_r1");
    const LightSeries light = light_of(campaign, campaign_cases[0]);
    EXPECT_EQ(light.days, 62);
    EXPECT_EQ(light.steps.size(), 62u * 24);
    EXPECT_NEAR(light.incident(), 8.681e6, 1e3);
    EXPECT_EQ(light.steps[0].temperature, 25.1);
    EXPECT_EQ(light.steps[0].humidity, 0.9);
    EXPECT_EQ(campaign.spec.light.dates, 3);
}

TEST(Climates, HoursAreInTheLocalTimeOfTheSite) {
    const auto series = [](const std::string& site, const std::string& file) {
        const Campaign campaign = read_campaign(
            (folder / "quickstart.toml").string(),
            {"site.utc_offset=" + site, "climate.utc_offset=" + file});
        return light_of(campaign, cases(campaign)[0]);
    };
    const LightSeries same = series("-6", "-6");
    EXPECT_EQ(same.utc_offset, -6);
    for (const double ahead : {-1., 1., 0.5}) {
        LightSeries other = series(fmt::format("{}", -6 + ahead), "-6");
        EXPECT_EQ(other.utc_offset, -6 + ahead);
        for (TimeStep& step : other.steps) step.hour -= ahead;
        expect_same(other, same);
    }
}

TEST(Climates, ResolvedCampaignsNeedNoFile) {
    const Campaign campaign = bondville();
    const Campaign again = parse_campaign(campaign.resolved, "elsewhere.toml");
    EXPECT_EQ(again.resolved, campaign.resolved);
    EXPECT_EQ(again.sha256, campaign.sha256);
    const Case chosen = cases(campaign)[0];
    expect_same(light_of(again, chosen), light_of(campaign, chosen));
    const std::string without =
        campaign.resolved.substr(0, campaign.resolved.find("[[weather]]"));
    EXPECT_NE(problem_of(without).find("has no [[weather]] of site"),
              std::string::npos);
    const std::string short_of =
        replaced(campaign.resolved, "diffuse = [0, ", "diffuse = [");
    EXPECT_NE(problem_of(short_of).find("weather.diffuse has 1487 values"),
              std::string::npos);
}

TEST(Climates, WindIsReadAndOtherAirVariablesAreEstimated) {
    const Campaign campaign =
        read_campaign((folder / "bondville.toml").string(),
                      {"climate.wind=[\"wind_m_s\", \"m/s\"]",
                       "climate.wind_height=9", "climate.co2=550"});
    const Campaign again = parse_campaign(campaign.resolved, "elsewhere.toml");
    EXPECT_EQ(again.resolved, campaign.resolved);
    const Case chosen = cases(again)[0];
    LightSeries light = light_of(again, chosen);
    EXPECT_EQ(light.co2, 550);
    EXPECT_EQ(light.steps[1].wind, 2.42);
    EXPECT_FALSE(light.steps[1].longwave);
    estimate_air(light, chosen.site, again.spec.par_fraction);
    EXPECT_EQ(light.estimated,
              (std::vector<std::string>{"pressure", "longwave radiation"}));
    EXPECT_EQ(light.wind_height, 9);
    EXPECT_EQ(light.steps[1].wind, 2.42);
    for (const TimeStep& step : light.steps) {
        EXPECT_NEAR(step.pressure.value(), 98.8, .1);  // Bondville has 99.0
        const double black =
            5.670374419e-8 * std::pow(*step.temperature + 273.15, 4);
        EXPECT_LE(step.longwave.value(), black * 1.01);
        EXPECT_GE(step.longwave.value(), black * .68);
    }
    LightSeries still = light_of(bondville(), chosen);
    EXPECT_EQ(still.co2, 400);
    estimate_air(still, chosen.site, again.spec.par_fraction);
    EXPECT_EQ(still.wind_height, 2);
    EXPECT_EQ(still.steps[1].wind, 2);
}

TEST(Climates, CloudsEmitLongwaveRadiation) {
    EXPECT_NEAR(standard_pressure(0), 101.325, 1e-12);
    EXPECT_NEAR(standard_pressure(1500), 84.6, .1);
    const double clear = sky_longwave(20, 15, 1);
    EXPECT_NEAR(clear, 340, 5);
    EXPECT_GT(sky_longwave(20, 20, 1), clear);
    EXPECT_GT(sky_longwave(20, 15, .5), clear);
    EXPECT_NEAR(sky_longwave(20, 15, 0), 418.7, .2);
}

TEST(Climates, NearInfraredIsStoredIfItIsTraced) {
    const Campaign usual = bondville();
    EXPECT_EQ(usual.resolved.find("nir_"), std::string::npos);
    const Case chosen = cases(usual)[0];
    for (const TimeStep& step : light_of(usual, chosen).steps)
        EXPECT_EQ(step.nir.beam + step.nir.diffuse, 0);

    const std::string file = (folder / "bondville.toml").string();
    const Problems problems;
    Spec spec =
        read_spec(text_of(file), file, TextSource::file, {}, false, problems);
    spec.plant.crop.follows[nir_band] = true;
    read_weathers(file, TextSource::file, spec, problems);
    ASSERT_TRUE(problems.empty());
    const Campaign again = parse_campaign(resolved_text(spec), "elsewhere");
    const std::string resolved = again.resolved;
    EXPECT_EQ(parse_campaign(resolved, "elsewhere").resolved, resolved);
    const LightSeries light = light_of(again, chosen);
    expect_same(light, light_of(resolve(spec), chosen));
    double nir = 0;
    for (std::size_t i = 0; i < light.steps.size(); ++i) {
        const TimeStep& step = light.steps[i];
        nir += step.nir.beam + step.nir.diffuse;
        EXPECT_EQ(step.par.beam, usual.spec.weathers[0].beam[0][i]);
        EXPECT_EQ(step.par.diffuse, usual.spec.weathers[0].diffuse[0][i]);
    }
    // Near infrared exceeds PAR, which is 8.681 MJ m-2 per day.
    EXPECT_NEAR(nir * 3600 / light.days / light.incident(), 1.287, .01);
    EXPECT_NE(problem_of(replaced(resolved, "nir_beam = [0, ", "nir_beam = ["))
                  .find("weather.nir_beam has 1487 values"),
              std::string::npos);
    const std::size_t last = resolved.find("nir_diffuse = ");
    EXPECT_NE(problem_of(std::string(resolved).erase(
                             last, resolved.find('\n', last) - last))
                  .find("weather.nir_diffuse has 0 values"),
              std::string::npos);
}

TEST(Climates, EachSiteMayHaveAWeatherFile) {
    const std::string other = temporary_file("own_weather.toml");
    std::string text = text_of(folder / "bondville.toml");
    const std::string file =
        (folder / "weather/bondville_2011_0721_0920.csv").string();
    text =
        replaced(text, "file = \"weather/bondville_2011_0721_0920.csv\"\n", "");
    text = replaced(text, "elevation = 213", "weather = \"" + file + "\"");
    text = replaced(text, "\"crops/",
                    (folder / "crops/").string().insert(0, "\""));
    std::ofstream(other) << text;
    const Campaign campaign = read_campaign(other);
    EXPECT_NE(campaign.resolved.find("weather = \"" + file), std::string::npos);
    // The site determines the position of the sun; the elevation of the site
    // has no effect on measured light.
    const Campaign usual = bondville();
    expect_same(light_of(campaign, cases(campaign)[0]),
                light_of(usual, cases(usual)[0]));
}

TEST(Climates, AnotherFileIsAnotherCampaign) {
    const Campaign campaign = bondville();
    const std::string was = campaign.resolved;
    const std::size_t sum = was.find("sha256 = \"") + 10;
    std::string is = was;
    is[sum] = is[sum] == '0' ? '1' : '0';
    is = replaced(is, "beam = [0, ", "beam = [1, ");
    const auto lines = differences(read_resolved(was), read_resolved(is),
                                   cases(campaign).front());
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].substr(0, 22), "weather[0].sha256 was ");
    // The message must not list all 1488 values.
    EXPECT_LT(lines[1].size(), 200u);
}

TEST(Climates, AreAbsentFromCampaignsOfClearDays) {
    const Campaign campaign = sample();
    EXPECT_FALSE(campaign.spec.light.dates);
    for (const char* key : {"weather", "climate", "\ndates"})
        EXPECT_EQ(campaign.resolved.find(key), std::string::npos) << key;
}

TEST(Climates, SeveralClearDaysAreOneCase) {
    const std::string text =
        replaced(sample_text(), "2025-08-07", "[2025-06-07, 2025-08-07]");
    const Campaign campaign = parse_campaign(text, "sample.toml");
    EXPECT_EQ(campaign.spec.days[0].name, "0607-0807");
    EXPECT_EQ(parse_campaign(campaign.resolved, "x").resolved,
              campaign.resolved);
    const Case chosen = cases(campaign)[0];
    Case june = chosen, august = chosen;
    june.day.dates.pop_back();
    august.day.dates.erase(august.day.dates.begin());
    EXPECT_NEAR(light_of(campaign, chosen).incident(),
                (light_of(campaign, june).incident() +
                 light_of(campaign, august).incident()) /
                    2,
                1e-6);
}

TEST(Climates, APolarDayEndsAtMidnight) {
    std::string text = replaced(sample_text(), "20:00:00", "\"24:00\"");
    text = replaced(text, "07:00:00", "00:00:00");
    const Campaign campaign = parse_campaign(text, "sample.toml");
    EXPECT_EQ(campaign.spec.days[0].value.end, 24);
    EXPECT_NE(campaign.resolved.find("end = \"24:00:00\""), std::string::npos);
    EXPECT_EQ(parse_campaign(campaign.resolved, "x").resolved,
              campaign.resolved);
}

TEST(Climates, YearsOfOneFileBecomeClimates) {
    const auto read = [](const std::string& climate) {
        return read_campaign_text(fmt::format(R"(
name = "years"
[[site]]
name = "bondville"
latitude = 40.05
longitude = -88.37
utc_offset = -6
[[climate]]
{}
time = ["time"]
stamp = "middle"
global = ["ppfd_umol", "umol/m2/s"]
[[spacing]]
row = 0.76
density = 7.5
[plant]
baseline = "crops/maize.toml"
[objective]
over = ["climate"]
[stop]
generations = 5
)",
                                              climate),
                                  (folder / "years.toml").string());
    };
    const Campaign campaign = read(
        "file = \"weather/bondville_{year}_0501_0930.csv\"\n"
        "from = 2011-05-01\nto = 2011-05-20\nyears = [2012, 2011]\n"
        "weights = [1, 3]");
    ASSERT_EQ(campaign.spec.climates.size(), 2u);
    EXPECT_EQ(campaign.spec.climates[0].name, "2012");
    EXPECT_EQ(to_string(campaign.spec.climates[0].value.period.to),
              "2012-05-20");
    const Case only = cases(campaign).front();
    ASSERT_EQ(only.scenarios.size(), 2u);
    EXPECT_EQ(only.scenarios[0].weight, 1);
    EXPECT_EQ(only.scenarios[1].weight, 3);
    // The light is that of a climate for each year.
    const Campaign of_one = read(
        "name = \"2012\"\nfile = \"weather/bondville_2012_0501_0930.csv\"\n"
        "from = 2012-05-01\nto = 2012-05-20");
    expect_same(light_of(campaign, only.scenarios[0]),
                light_of(of_one, cases(of_one).front()));
    // A resolved campaign contains each year with its weight.
    EXPECT_EQ(campaign.resolved.find("years ="), std::string::npos);
    const Campaign again = parse_campaign(campaign.resolved, "again");
    EXPECT_EQ(again.resolved, campaign.resolved);
    EXPECT_EQ(cases(again).front().scenarios[1].weight, 3);
    // A name comes before the years.
    EXPECT_EQ(read("name = \"late\"\n"
                   "file = \"weather/bondville_{year}_0501_0930.csv\"\n"
                   "from = 2012-05-01\nto = 2012-05-20\nyears = [2011]")
                  .spec.climates[0]
                  .name,
              "late_2011");
}

}  // namespace ideotype
