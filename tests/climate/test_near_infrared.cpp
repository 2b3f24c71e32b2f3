// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/climate/weather.hpp"
#include "ideotype/core/file.hpp"
#include "ideotype/core/units.hpp"
#include "made_csv.hpp"

namespace ideotype {
namespace {

const Site bondville{"bondville", 40.05, -88.37, -6, 213};

double sum(const Irradiance& light) {
    return light.beam + light.diffuse;
}

//! Returns the ratio of PAR photons to solar energy [umol J-1] (Alados et al.
//! 1996).
double photons_per_joule(double clearness, double cosine) {
    return 1.832 - .191 * std::log(clearness) + .099 * cosine;
}

LightSeries season(const std::string& unit, double par_fraction) {
    WeatherRequest request{"bondville.csv", bondville};
    request.columns.time = {"time"};
    request.columns.stamp = Stamp::middle;
    request.columns.global = Column{"ppfd_umol", unit};
    request.columns.diffuse_fraction = Column{"diffuse_fraction_erbs", "1"};
    request.par_fraction = par_fraction;
    return parse_weather(read_file(IDEOTYPE_CAMPAIGNS
                                   "/weather/bondville_2011_0721_0920.csv",
                                   most_data_bytes)
                             .text,
                         request)
        .series;
}

}  // namespace

TEST(ParShare, ShareSolvesTheEquationOfAlados) {
    for (const double zenith : {0., 20., 45., 70., 84.})
        for (const double clearness : {.06, .1, .3, .5, .7, .8, .95}) {
            const double cosine = std::cos(zenith * degree);
            const double solar = clearness * 1361 * cosine;
            const double share =
                photons_per_joule(clearness, cosine) / mol_per_mj_par;
            EXPECT_NEAR(par_share(share * solar, 1361, zenith), share, 1e-14);
        }
}

TEST(ParShare, ShareFallsAsTheSkyClears) {
    const auto share = [](double par) { return par_share(par, 1361, 40); };
    double before = 1;
    for (double par = 30; par < 430; par += 10) {
        EXPECT_LT(share(par), before);
        before = share(par);
    }
    // The sky is first clear, then half clear, then overcast.
    EXPECT_NEAR(share(340), .43, .01);
    EXPECT_NEAR(share(235), .445, .01);
    EXPECT_NEAR(share(50), .51, .01);
}

TEST(ParShare, ShareIsBoundedAtNightAndWithLowSun) {
    for (const double zenith : {0., 60., 86.9, 88., 90., 95., 120., 180.})
        for (const double par : {0., 1e-9, 1., 50., 400., 5000.}) {
            EXPECT_GT(par_share(par, 1361, zenith), .40);
            EXPECT_LT(par_share(par, 1361, zenith), .55);
        }
    EXPECT_EQ(par_share(7, 1361, 89), par_share(7, 1361, 120));
}

TEST(NearInfrared, NearInfraredIsTheRestOfAClearSky) {
    const DaySpan span{{{2025, 6, 21}, {2025, 12, 21}}, 4, 20, 60};
    for (const TimeStep& step : clear_days(bondville, span, .48).steps) {
        const Irradiance solar = clear_sky(bondville, step.date, step.sun);
        EXPECT_EQ(step.par.beam, .48 * solar.beam);
        EXPECT_EQ(step.par.diffuse, .48 * solar.diffuse);
        EXPECT_DOUBLE_EQ(step.par.beam + step.nir.beam, solar.beam);
        EXPECT_DOUBLE_EQ(step.par.diffuse + step.nir.diffuse, solar.diffuse);
    }
}

TEST(NearInfrared, NearInfraredIsTheRestOfSolarRadiation) {
    const MadeCsv made;
    const LightSeries series =
        parse_weather(made.text(), made_request()).series;
    double largest = 0;
    for (std::size_t i = 0; i < 24; ++i) {
        const TimeStep& step = series.steps[i];
        const double global = made.global(static_cast<int>(i));
        // Values in the file are rounded to six decimals.
        EXPECT_NEAR(sum(step.par) + sum(step.nir), global, 1e-6);
        EXPECT_NEAR(sum(step.nir), .55 * global, 1e-6);
        EXPECT_DOUBLE_EQ(step.nir.beam * step.par.diffuse,
                         step.nir.diffuse * step.par.beam);
        largest = std::max(largest, sum(step.nir));
    }
    EXPECT_GT(largest, 300);
}

TEST(NearInfrared, NearInfraredFollowsFromPhotons) {
    double par = 0, solar = 0;
    for (const TimeStep& step : season("umol/m2/s", .45).steps) {
        const double global = sum(step.par) + sum(step.nir);
        par += sum(step.par);
        solar += global;
        EXPECT_GE(step.nir.beam, 0);
        EXPECT_DOUBLE_EQ(step.nir.beam * step.par.diffuse,
                         step.nir.diffuse * step.par.beam);
        if (sum(step.par) == 0) {
            EXPECT_EQ(sum(step.nir), 0);
        }
        const double cosine = std::cos(step.sun.zenith * degree);
        const double clearness =
            global / (extraterrestrial_normal(step.date) * cosine);
        if (cosine < .065 || clearness < .05 || clearness > 1) continue;
        EXPECT_NEAR(sum(step.par) * mol_per_mj_par,
                    photons_per_joule(clearness, cosine) * global, 1e-9);
    }
    // Measured ratios are about 1.97 on clear days and 2.10 on overcast days.
    EXPECT_NEAR(par * mol_per_mj_par / solar, 2.0, .02);
}

TEST(NearInfrared, ParDoesNotDependOnNearInfrared) {
    // Reference values, to the last bit: noon of 21 July, computed without near
    // infrared.
    const TimeStep noon = season("umol/m2/s", .45).steps.at(12);
    EXPECT_EQ(noon.par.beam, 0x1.2357f28e48d29p+8);
    EXPECT_EQ(noon.par.diffuse, 0x1.889cd959115d8p+6);
    // The key par_fraction does not affect light given in photons.
    const TimeStep other = season("umol/m2/s", .5).steps.at(12);
    EXPECT_DOUBLE_EQ(other.par.beam, noon.par.beam);
    EXPECT_NEAR(other.nir.beam, noon.nir.beam, 1e-9);
    EXPECT_NEAR(other.nir.diffuse, noon.nir.diffuse, 1e-9);
}

TEST(NearInfrared, DiffuseLightMayHaveAnotherUnitThanGlobalLight) {
    // If global light is solar radiation, diffuse light given in photons does
    // not change the sum.
    MadeCsv made;
    made.header += ",sky";
    for (std::string& row : made.rows) row += ",0";
    WeatherRequest request = made_request();
    request.columns.diffuse = Column{"sky", "umol/m2/s"};
    const LightSeries series = parse_weather(made.text(), request).series;
    EXPECT_NEAR(sum(series.steps[12].nir), .55 * made.global(12), 1e-6);
}

}  // namespace ideotype
