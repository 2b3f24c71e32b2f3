// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ideotype/canopy/quantities.hpp"
#include "mesh_rates.hpp"
#include "temporary_folder.hpp"

namespace ideotype {
namespace {

MeshSpec maize(double elevation, double azimuth) {
    MeshSpec options = reference("maize1", {.76, .15});
    options.sun = {elevation, azimuth};
    options.optics.leaf = {0, 0};
    options.soil_albedo = 0;
    return options;
}

//! Some light is scattered, so that totals are not whole numbers of paths.
MeshSpec lit_maize() {
    MeshSpec options = maize(60, 180);
    options.optics.leaf = {.05, .05};
    return options;
}

ExitCode code_of(const MeshSpec& options) {
    try {
        check(options);
    } catch (const Error& error) {
        return error.exit_code();
    }
    return ExitCode::ok;
}

TEST(MeshStudy, MaizeAgreesWithADoublePrecisionTracer) {
    MeshSpec options = maize(60, 180);
    options.tolerance = 1e-4;
    const MeshReport report = study(options);
    const Estimate leaf = report.canopy.par().light.day.leaves;
    // The standard error from 32 randomisations is accurate to about 12 %, and
    // so are the trials that choose the number of paths.
    EXPECT_LE(leaf.standard_error, 1.5e-4 * leaf.mean);
    EXPECT_NEAR(leaf.mean, .9206372,
                4 * std::hypot(leaf.standard_error, 3.39e-5));
    EXPECT_NEAR(report.canopy.ground_area, .114, 1e-12);
    EXPECT_LT(report.canopy.par().light.balance_error, 1e-12);
}

TEST(MeshStudy, OneSheetOverSoilIsExact) {
    MeshSpec options = reference("sheets1", {1, 1});
    options.sky = SkyModel::uniform;
    options.soil_albedo = .2;
    options.tolerance = 1e-4;
    const BudgetEstimate day = study(options).canopy.par().light.day;
    const auto expect = [](Estimate ours, double exact) {
        EXPECT_LT(ours.standard_error, 2e-4);
        EXPECT_NEAR(ours.mean, exact, 4 * ours.standard_error + 1e-7);
    };
    expect(day.leaves, .9090909);
    expect(day.soil, .0404040);
    expect(day.reflected, .0505051);
}

TEST(MeshStudy, ExtinctionOfBlackHorizontalLeavesIsThatOfBeersLaw) {
    MeshSpec options = reference("poisson_horizontal_L3", {1, 1});
    options.optics.leaf = {0, 0};
    options.soil_albedo = 0;
    options.sky = SkyModel::uniform;
    for (const Measured& number : measure_numbers(study(options).canopy))
        if (number.quantity.name == "extinction_coefficient") {
            // A mesh of finitely many leaves deviates slightly from theory.
            EXPECT_NEAR(number.estimate.mean, 1,
                        4 * number.estimate.standard_error + .01);
            EXPECT_LT(number.estimate.standard_error, .01);
            return;
        }
    FAIL();
}

TEST(MeshStudy, StalksHaveDifferentOpticsFromLeaves) {
    // A leaf sheet covers one half of the ground, and a stalk sheet the other
    // half.
    const std::string path = temporary_file("halves.obj");
    std::ofstream(path) << "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                           "v .5 0 1\nv .5 1 1\n"
                           "g plant001_leaf01\nf 1 5 6 4\n"
                           "g plant001_stalk\nf 5 2 3 6\n";
    MeshSpec options;
    options.path = path;
    options.period = {1, 1};
    options.sun = {60, 180};
    options.soil_albedo = 0;
    options.optics.leaf = {0, 0};
    options.optics.stalk = {.3, 0};
    options.tolerance = 1e-3;
    const CanopyReport canopy = study(options).canopy;
    EXPECT_NEAR(canopy.lai, .5, 1e-12);
    const BudgetEstimate& day = canopy.par().light.day;
    EXPECT_NEAR(day.leaves.mean, .5, 4 * day.leaves.standard_error + 1e-6);
    EXPECT_NEAR(day.organs.mean, .35, 4 * day.organs.standard_error + 1e-6);
    EXPECT_NEAR(day.reflected.mean, .15,
                4 * day.reflected.standard_error + 1e-6);
}

TEST(MeshStudy, AMeshInCentimetresCausesAWarning) {
    const std::string path = temporary_file("tall.obj");
    const auto warnings = [&](double height) {
        std::ofstream(path)
            << "v 0 0 0\nv 1 0 0\nv 0 1 " << height << "\nf 1 2 3\n";
        MeshSpec options;
        options.path = path;
        options.period = {1, 1};
        options.sun = {60, 180};
        options.paths = 1000;
        return study(options).warnings;
    };
    EXPECT_TRUE(warnings(19).empty());
    ASSERT_EQ(warnings(230).size(), 1u);
    EXPECT_NE(warnings(230)[0].find("230 m high"), std::string::npos);
    // A nearly horizontal ray would cross the cell a million times.
    EXPECT_THROW(warnings(1e6), Error);
}

TEST(MeshStudy, AMeshBelowTheSoilCausesAWarningAndATinyOneIsRefused) {
    const std::string path = temporary_file("low.obj");
    const auto warnings = [&](double size, double lowest) {
        std::ofstream(path) << fmt::format(
            "v 0 0 1\nv {0} 0 1\nv 0 {0} {1}\nf 1 2 3\n", size, lowest);
        MeshSpec options;
        options.path = path;
        options.period = {1, 1};
        options.sun = {60, 180};
        return study(options).warnings;
    };
    EXPECT_TRUE(warnings(.5, 0).empty());
    ASSERT_EQ(warnings(.5, -.25).size(), 1u);
    EXPECT_EQ(warnings(.5, -.25)[0],
              "the mesh reaches 0.25 m below the soil (z = 0), where there is "
              "no light; lift it");
    EXPECT_THROW(warnings(1e-7, 1), Error);
    EXPECT_THROW(warnings(200, 1), Error);
}

TEST(MeshStudy, TheSameOptionsGiveTheSameBits) {
    const MeshReport a = study(lit_maize()), b = study(lit_maize(), key_itself);
    EXPECT_EQ(a.canopy.paths, b.canopy.paths);
    EXPECT_EQ(a.canopy.par().light.day.leaves.mean,
              b.canopy.par().light.day.leaves.mean);
    MeshSpec other = lit_maize();
    other.seed = 2;
    EXPECT_NE(study(other).canopy.par().light.day.leaves.mean,
              a.canopy.par().light.day.leaves.mean);
}

TEST(MeshStudy, ATighterToleranceTakesMorePathsAndIsMet) {
    MeshSpec options = lit_maize();
    options.tolerance = 1e-2;
    const std::uint64_t few = study(options).canopy.paths;
    options.tolerance = 3e-4;
    const MeshReport report = study(options);
    EXPECT_GT(report.canopy.paths, few);
    const Estimate& leaves = report.canopy.par().light.day.leaves;
    EXPECT_LE(leaves.standard_error, 4.5e-4 * leaves.mean);
    EXPECT_FALSE(report.canopy.is_capped);
}

TEST(MeshStudy, AtLeastTheRequestedPathsAreTraced) {
    MeshSpec options = maize(30, 90);
    for (const std::uint64_t paths : {1, 2, 31, 33, 4096, 5000}) {
        options.paths = paths;
        const MeshReport report = study(options);
        EXPECT_GE(report.canopy.paths, paths);
        EXPECT_LE(report.canopy.paths, 4 * paths);
        EXPECT_TRUE(
            std::isfinite(report.canopy.par().light.day.leaves.standard_error));
    }
}

TEST(MeshStudy, AFieldOfUnturnedPlantsIsThePlantInItsCell) {
    MeshSpec field = maize(45, 120);
    field.tolerance = 2e-4;
    const MeshReport plant = study(field);
    field.period.reset();
    field.field = {2, 3, .76, .15};
    const MeshReport stand = study(field);
    EXPECT_NEAR(stand.canopy.ground_area, 6 * .76 * .15, 1e-12);
    EXPECT_NEAR(stand.canopy.lai, plant.canopy.lai, 1e-9);
    const Estimate a = plant.canopy.par().light.day.leaves,
                   b = stand.canopy.par().light.day.leaves;
    EXPECT_NEAR(a.mean, b.mean,
                4 * std::hypot(a.standard_error, b.standard_error));
    field.jitter = 20;
    EXPECT_NE(study(field).canopy.par().light.day.leaves.mean, b.mean);
}

TEST(MeshStudy, ADayHasHoursThatSumToIt) {
    MeshSpec options = maize(1, 0);
    options.sun.reset();
    options.site = Site{"", 42, -93.6, -5};
    options.date = Date{2025, 8, 7};
    const DayReport light = study(options).canopy.par().light;
    EXPECT_NEAR(light.day.incident / 12.2e6, 1, .05);
    double leaves = 0;
    for (const StepReport& step : light.steps)
        leaves += 3600 * step.budget.leaves.mean;
    EXPECT_NEAR(leaves / light.day.leaves.mean, 1, 1e-9);
    EXPECT_LT(light.balance_error, 1e-12);
}

TEST(MeshStudy, AnIsolatedPlotAbsorbsMoreThanItsGroundReceives) {
    MeshSpec options = maize(30, 90);
    options.period.reset();
    options.boundary = Boundary::isolated;
    options.ground_area = .114;
    const CanopyReport alone = study(options).canopy;
    EXPECT_GT(alone.par().light.day.leaves.mean, 1.5);
    EXPECT_GT(alone.par().light.day.entered.mean,
              alone.par().light.day.leaves.mean);
    EXPECT_LT(alone.par().light.balance_error, 1e-11);
    ASSERT_TRUE(alone.par().light.steps[0].sunlit);
    EXPECT_GT(alone.par().light.steps[0].sunlit->mean, .3);
}

TEST(MeshStudy, PolarNightIsDarkAndFinite) {
    MeshSpec options = maize(1, 0);
    options.sun.reset();
    options.site = Site{"", 85, 0, 0};
    options.date = Date{2025, 12, 21};
    const MeshReport report = study(options);
    EXPECT_EQ(report.canopy.par().light.day.incident, 0);
    EXPECT_EQ(report.canopy.par().light.day.leaves.mean, 0);
}

TEST(MeshStudy, ContradictionsAreWrongUsage) {
    EXPECT_EQ(code_of(maize(60, 180)), ExitCode::ok);
    const auto refuses = [](auto change) {
        MeshSpec options = maize(60, 180);
        change(options);
        EXPECT_EQ(code_of(options), ExitCode::usage);
    };
    refuses([](auto& o) { o.period.reset(); });
    refuses([](auto& o) { o.field = {1, 1, 1, 1}; });
    refuses([](auto& o) { o.jitter = 1; });
    refuses([](auto& o) { o.ground_area = 1; });
    refuses([](auto& o) { o.boundary = Boundary::isolated; });
    refuses([](auto& o) { o.sun.reset(); });
    refuses([](auto& o) { o.sun->elevation = 0; });
    refuses([](auto& o) { o.sky = SkyModel::uniform; });
    refuses([](auto& o) { o.site = Site{}; });
    refuses([](auto& o) { o.optics.leaf = {.6, .5}; });
    refuses([](auto& o) { o.optics.stalk = {.6, .5}; });
}

TEST(MeshStudy, AMeshOutOfProportionToItsPeriodIsRefused) {
    MeshSpec options = maize(60, 180);
    options.period = {1e-6, 1e-6};
    EXPECT_THROW(study(options), Error);
}

//! Returns the message by which options are refused, or "" if they are
//! accepted.
std::string refusal_of(const MeshSpec& options,
                       ExitCode expected = ExitCode::usage) {
    try {
        study(options);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), expected) << error.what();
        return error.what();
    }
}

TEST(MeshStudy, AFaceOfManyPeriodsIsRefusedBeforeItIsTraced) {
    const std::string path = temporary_file("wide.obj");
    const auto refusal = [&](double width) {
        std::ofstream(path)
            << fmt::format("v 0 0 1\nv {} 0 1\nv 0 1e-3 1\nf 1 2 3\n", width);
        MeshSpec options;
        options.path = path;
        options.period = {1, 1};
        options.sun = {60, 180};
        options.paths = 64;  // a number of paths that is never refused
        return refusal_of(options, ExitCode::runtime);
    };
    EXPECT_EQ(refusal(50), "");
    EXPECT_EQ(refusal(1e6),
              "the mesh has a face of 1e+06 m along x over a period of 1 m "
              "(the limit is 100 times the period); check that it is in "
              "metres");
}

TEST(MeshStudy, ATooLowSunIsRefused) {
    const auto refusal = [](double elevation) {
        return refusal_of(maize(elevation, 180));
    };
    EXPECT_EQ(refusal(0.2), "");
    for (const double elevation : {1e-9, 1e-3})
        EXPECT_NE(refusal(elevation).find("(the limit is 1e+04); give 0.0"),
                  std::string::npos)
            << refusal(elevation);
    // The settings that the message advises are accepted.
    const std::string text = refusal(1e-9);
    EXPECT_EQ(refusal(std::stod(text.substr(text.find("give ") + 5))), "");
}

//! Returns the message by which the value of a key is refused, or "".
std::string refusal_of(const std::string& key,
                       const std::vector<GivenValue>& values) {
    try {
        read_mesh_spec({{key, values}}, key_itself);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::usage) << error.what();
        return error.what();
    }
}

TEST(MeshStudy, NumbersThatAreNotFiniteAreNamed) {
    using namespace std::string_literals;
    for (const auto& value : {"nan"s, "inf"s})
        for (const auto& [key, values] :
             GivenKeys{{"period", {value, "1"s}},
                       {"ground_area", {value}},
                       {"sun", {"60"s, value}},
                       {"beam_ppfd", {value}},
                       {"leaf_reflectance", {value}},
                       {"soil_albedo", {value}},
                       {"tolerance", {value}},
                       {"field", {"1"s, "1"s, value, "1"s}},
                       {"jitter", {value}}}) {
            const std::string text = refusal_of(key, values);
            EXPECT_EQ(text.find(key), 0u) << text;
            EXPECT_NE(text.find("is " + value + " (not a finite number)"),
                      std::string::npos)
                << text;
        }
}

TEST(MeshStudy, ValuesOutsideTheirRangesAreNamed) {
    using namespace std::string_literals;
    EXPECT_EQ(refusal_of("sun", {60.0, std::int64_t{180}}), "");
    EXPECT_EQ(refusal_of("sun", {".6e2"s, "-180"s}), "");
    for (const auto& [key, values] :
         GivenKeys{{"period", {0.0, 1.0}},
                   {"sun", {91.0, 0.0}},
                   {"site", {42.0, 181.0, 0.0}},
                   {"field", {std::int64_t{0}, std::int64_t{1}, 1.0, 1.0}},
                   {"leaf_reflectance", {-.1}},
                   {"stalk_transmittance", {-.5}},
                   {"soil_albedo", {1.1}},
                   {"tolerance", {0.0}},
                   {"paths", {std::int64_t{0}}},
                   {"date", {"1949-01-01"s}}})
        EXPECT_NE(refusal_of(key, values).find("the range"), std::string::npos)
            << key << refusal_of(key, values);
}

TEST(MeshStudy, ValuesOfAnotherTypeAreNamed) {
    using namespace std::string_literals;
    EXPECT_EQ(refusal_of("sun", {"6o"s, "1"s}),
              "sun: elevation is 6o (not a number); correct it");
    EXPECT_EQ(refusal_of("seed", {"1.5"s}),
              "seed is 1.5 (not a whole number); correct it");
    EXPECT_EQ(refusal_of("date", {"7.8.2025"s}),
              "date is 7.8.2025 (not a date); write it as YYYY-MM-DD");
    EXPECT_EQ(refusal_of("sun", {60.0}),
              "sun takes 2 values: elevation, azimuth");
    EXPECT_EQ(refusal_of("tolerance", {60.0, 1.0}),
              "tolerance takes one value");
    EXPECT_NE(refusal_of("sky", {"grey"s}).find("use \"uniform\" or"),
              std::string::npos)
        << refusal_of("sky", {"grey"s});
}

TEST(MeshStudy, KeysThatExcludeOthersAreRefused) {
    const auto refusal = [](const GivenKeys& given) {
        try {
            read_mesh_spec(given, key_itself);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal({{"scene", {"x.toml"}}, {"soil_albedo", {.1}}}),
              "scene excludes soil_albedo");
    EXPECT_EQ(refusal({{"paths", {std::int64_t{9}}}, {"tolerance", {.1}}}),
              "tolerance excludes paths");
}

}  // namespace
}  // namespace ideotype
