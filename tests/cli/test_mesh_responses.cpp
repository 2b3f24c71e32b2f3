// SPDX-License-Identifier: Apache-2.0
// Tests the response of leaves of meshes to light and weather against exact
// values.
#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mesh_rates.hpp"

namespace ideotype {
namespace {

TEST(Assimilation, OfALinearResponseIsProportionalToAbsorbedLight) {
    MeshSpec options = mesh("maize1", {.76, .15});
    options.photosynthesis = table("linear", "phi=0.06\ntheta=1\namax = 1e9\n");
    options.sun = {30, 120};
    options.sky = SkyModel::uniform;
    options.beam_ppfd = 700;
    options.sky_ppfd = 300;
    const CanopyReport report = study(options).canopy;
    EXPECT_NEAR(report.assimilation->gross.sum.mean * 1e6 /
                    (.06 * report.par().light.day.leaves.mean),
                1, 1e-12);
    EXPECT_NEAR(report.assimilation->gross.sum.standard_error * 1e6 /
                    (.06 * report.par().light.day.leaves.standard_error),
                1, 1e-9);
}

TEST(Assimilation, OfSheetsIsExact) {
    MeshSpec options = mesh("sheets1", {1, 1});
    options.photosynthesis = table("sheets", "amax = 50\n");
    options.soil_albedo = .2;
    options.sun = {60, 90};
    options.beam_ppfd = 1000;
    const Estimate one = rates(options).gross;
    EXPECT_NEAR(one.mean, 33.6839, 4 * one.standard_error);
    options.path = IDEOTYPE_TEST_DATA "/reference/sheets5.obj";
    options.optics.leaf = {.45, .45};
    options.soil_albedo = .3;
    options.beam_ppfd = 2000;
    const Estimate five = rates(options).gross;
    EXPECT_NEAR(five.mean, 36.053, 4 * five.standard_error + 5e-4);
    EXPECT_LT(five.standard_error, .02);
}

TEST(Assimilation, ASheetInTheSunFallsIntoOneClassOfLight) {
    MeshSpec options = mesh("sheets1", {1, 1});
    options.photosynthesis = table("sheet", "amax = 50\n");
    options.soil_albedo = .2;
    options.sun = {60, 90};
    options.beam_ppfd = 1010;
    const LightClassReport report = *study(options).canopy.light_classes;
    // The leaf absorbs 0.9 of the beam, and 0.9 of the 10.1 that the soil
    // reflects.
    const std::size_t lit = class_of(918), dark = class_of(9);
    for (std::size_t c = 0; c < ppfd_classes; ++c) {
        EXPECT_NEAR(report.sunlit[c].mean, c == lit, 1e-9) << c;
        EXPECT_NEAR(report.shaded[c].mean, 0, 1e-9) << c;
    }
    options.sun.reset();
    options.beam_ppfd.reset();
    options.sky = SkyModel::uniform;
    options.sky_ppfd = 10;
    EXPECT_NEAR(study(options).canopy.light_classes->shaded[dark].mean, 1,
                1e-12);
}

TEST(Assimilation, OfBlackSphericalLeavesIsExact) {
    constexpr double normal = 1800;
    for (const auto& [elevation, exact] :
         {std::pair(90, 45.665), {60, 41.899}, {15, 15.167}}) {
        MeshSpec options = mesh("poisson_spherical_L3", {1, 1});
        options.photosynthesis = table("black", "amax = 50\n");
        options.optics.leaf = {0, 0};
        options.soil_albedo = 0;
        options.sun = {1. * elevation, 90};
        options.beam_ppfd =
            normal * std::sin(elevation * 3.14159265358979 / 180);
        const Estimate gross = rates(options).gross;
        // A mesh of finitely many leaves deviates slightly from theory.
        EXPECT_NEAR(gross.mean, exact, 4 * gross.standard_error + .005 * exact);
    }
}

TEST(Assimilation, OfWeakLeavesIsProportionalToSunlitLeafArea) {
    MeshSpec options = mesh("maize1", {.76, .15});
    options.photosynthesis = table("weak", "amax = 1e-9\n");
    options.optics.leaf = {0, 0};
    options.soil_albedo = 0;
    options.sun = {60, 180};
    options.beam_ppfd = 1500;
    const Estimate gross = scaled(rates(options).gross, 1e9);
    EXPECT_NEAR(gross.mean, 1.342278,
                4 * std::hypot(gross.standard_error, .00025));
}

//! Returns a file with the weather of Bondville until the given day.
std::string season(const std::string& to) {
    const std::string path = temporary_file("to_" + to + ".toml");
    std::ofstream(path) << fmt::format(
        "[site]\nlatitude = 40.05\nlongitude = -88.37\nutc_offset = -6\n"
        "elevation = 213\n[climate]\nfile = \"{}/weather/"
        "bondville_2011_0721_0920.csv\"\nfrom = 2011-07-21\n"
        "to = {}\ntime = [\"time\"]\nstamp = \"middle\"\n"
        "global = [\"ppfd_umol\", \"umol/m2/s\"]\n"
        "diffuse_fraction = [\"diffuse_fraction_erbs\", \"1\"]\n"
        "temperature = [\"temp_c\", \"C\"]\nhumidity = [\"rh\", \"1\"]\n",
        IDEOTYPE_CAMPAIGNS, to);
    return path;
}

TEST(Assimilation, ByCollatzFollowsTheWeather) {
    MeshSpec options = mesh("maize1", {.76, .15});
    options.climate = season("2011-07-23");
    options.tolerance = 3e-3;
    // By default the response is that of the table; it follows the weather only
    // if the table requests it.
    options.photosynthesis = table("still", "model = 'collatz'\n");
    const CanopyReport still = study(options).canopy;
    options.photosynthesis =
        table("air", "model = 'collatz'\nweather = true\n");
    const CanopyReport moved = study(options).canopy;
    const double linear = .067 * 4.57e-6 * moved.par().light.day.leaves.mean;
    EXPECT_LT(moved.assimilation->gross.sum.mean, .9 * linear);
    EXPECT_GT(moved.assimilation->gross.sum.mean, .4 * linear);
    // Under equal light, temperatures below 30 deg C reduce both nocturnal
    // respiration and assimilation by day.
    EXPECT_LT(sum_of(moved.assimilation->losses).at_night,
              .9 * sum_of(still.assimilation->losses).at_night);
    EXPECT_GT(std::abs(moved.assimilation->gross.sum.mean -
                       still.assimilation->gross.sum.mean),
              .003 * still.assimilation->gross.sum.mean);
}

TEST(Assimilation, OfASeasonIsThatOfItsHours) {
    MeshSpec options = mesh("maize1", {.76, .15});
    options.climate = season("2011-09-20");
    options.photosynthesis = table("leaves", "amax = 50\nrd = 2\n");
    options.soil_albedo = 0;
    options.tolerance = 2e-3;
    const CanopyReport report = study(options).canopy;
    EXPECT_EQ(report.days, 62);
    // The reference excludes the hours around sunrise and sunset, which
    // contribute about 0.3 %.
    const Estimate gross = report.assimilation->gross.sum;
    EXPECT_NEAR(gross.mean, 1.5318 * 1.003,
                4 * std::hypot(gross.standard_error, .0009) + .002 * 1.5318);
    options.sun = {60, 180};
    EXPECT_THROW(check(options), Error);
}

//! Makes two sheets in the given groups, each over one half of the ground.
MeshSpec halves(const std::string& first, const std::string& second) {
    MeshSpec options = mesh("sheets1", {1, 1});
    options.path = temporary_file("two_groups.obj");
    std::ofstream(options.path)
        << "v 0 0 1\nv .5 0 1\nv .5 1 1\nv 0 1 1\nv 1 0 1\nv 1 1 1\n"
        << "g " << first << "\nf 1 2 3 4\ng " << second << "\nf 2 5 6 3\n";
    options.optics.leaf = {0, 0};
    options.soil_albedo = 0;
    options.sun = {60, 90};
    options.beam_ppfd = 1000;
    options.tolerance = .01;
    return options;
}

TEST(Assimilation, OfGroupsUsesTheLeafRanksOfAnyMesh) {
    const auto response = [](double amax) {
        return Hyperbola{.06, .7, amax}.gross(1000) / 2;
    };
    MeshSpec options = halves("leaf02", "wheat_leaf01");
    options.photosynthesis = table("ranks", "amax = [30, 50]\n");
    const Rates ranked = rates(options);
    for (const auto& [group, amax] : {std::pair(0u, 50.), {1u, 30.}})
        EXPECT_NEAR(ranked.groups[group].mean, response(amax),
                    4 * ranked.groups[group].standard_error + 1e-6);
    EXPECT_NEAR(ranked.net.mean, ranked.gross.mean - .04 * (30 + 50) / 2, 1e-9);

    options = halves("left", "right");
    options.photosynthesis = table("one", "amax = 40\n");
    EXPECT_NEAR(rates(options).gross.mean, 2 * response(40), 1e-6);
    options.photosynthesis = table("ranks", "amax = [30, 50]\n");
    try {
        study(options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("as in leaf01"),
                  std::string::npos);
    }
}

TEST(Assimilation, OfASingleLeafIsThatOfItsLight) {
    MeshSpec options = halves("leaf", "stalk");
    options.photosynthesis = table("one", "amax = 40\n");
    options.optics.stalk = {0, 0};
    const Rates computed = rates(options);
    const Hyperbola response{.06, .7, 40};
    EXPECT_NEAR(computed.gross.mean, response.gross(1000) / 2,
                4 * computed.gross.standard_error + 1e-6);
    EXPECT_LT(computed.gross.standard_error, .2);
}

TEST(Assimilation, NeedsTheIrradiance) {
    MeshSpec options = mesh("maize1", {.76, .15});
    options.photosynthesis = table("any", "amax = 50\n");
    options.sun = {60, 180};
    EXPECT_THROW(check(options), Error);
    options.beam_ppfd = 1500;
    EXPECT_NO_THROW(check(options));
    options.sky_ppfd = 300;
    EXPECT_THROW(check(options), Error);
}

TEST(Assimilation, IsExactOnlyOnRequest) {
    MeshSpec options = mesh("maize1", {.76, .15});
    options.sun = {60, 180};
    options.is_exact = true;
    EXPECT_THROW(check(options), Error);
}

TEST(Assimilation, FilesWithMistakesAreRefusedInOnePass) {
    MeshSpec options = mesh("maize1", {.76, .15});
    options.sun = {60, 180};
    options.beam_ppfd = 1500;
    options.photosynthesis =
        table("wrong",
              "model = 'hyperbola'\nvmax = 39\namx = 50\n"
              "theta = 2\nrd = [1, 2]\nphi = [0.06, 0.06, 0.06]\n");
    try {
        study(options);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().size(), 4u);
    }
    options.photosynthesis = table("lists", "amax = [40, 50]\n");
    EXPECT_THROW(study(options), Error);
}

}  // namespace
}  // namespace ideotype
