// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/device.hpp"
#include "two_leaves.hpp"

namespace ideotype {
namespace {

//! Whether all randomisations share a field or each has one.
enum class Fields { one, each };

class TwoLeaves : public ::testing::Test {
  protected:
    CanopyReport evaluated(Fields fields = Fields::one) {
        request.accuracy.fields =
            fields == Fields::each ? request.accuracy.randomisations : 1;
        return evaluate(request, device);
    }

    const Device device{Device::supported_isas().back()};
    CanopyRequest request = two_leaves({512, 8});
};

TEST_F(TwoLeaves, PartsOfTheLightSumToWhatFalls) {
    const CanopyReport report = evaluated();
    const BudgetEstimate& day = report.par().light.day;
    EXPECT_NEAR((day.leaves.mean + day.organs.mean + day.soil.mean +
                 day.reflected.mean) /
                    day.incident,
                1, 1e-12);
    double leaves = 0;
    for (const Estimate& layer : report.par().light.layers)
        leaves += layer.mean;
    EXPECT_NEAR(leaves / day.leaves.mean, 1, 1e-12);
    // Eight randomisations know their error to a quarter.
    EXPECT_LT(day.leaves.standard_error, .03 * day.leaves.mean);
    EXPECT_EQ(report.paths, 8u * 512u);
    EXPECT_NEAR(report.lai, .7455 * (.7 * .08 + .5 * .06) / (.76 * .15), .01);
    const double stalk = report.plant_area_index - report.lai;
    EXPECT_GT(stalk, 0);
    EXPECT_EQ(measure_objective("plant_area_index", report).estimate.mean,
              report.lai + stalk);
}

TEST_F(TwoLeaves, AFieldForEachRandomisationAgreesWithOne) {
    const Estimate one = evaluated().par().light.day.leaves;
    const Estimate each = evaluated(Fields::each).par().light.day.leaves;
    EXPECT_NE(one.mean, each.mean);
    EXPECT_NEAR(one.mean / each.mean, 1, .05);
}

TEST_F(TwoLeaves, ProfilesAreKnownByRandomisation) {
    request.scene.components[0].photosynthesis.emplace();
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        for (const std::string name :
             {"absorbed_by_leaf", "absorbed_by_layer", "assimilation_by_leaf",
              "net_assimilation_by_leaf", "assimilation_by_layer"}) {
            const std::vector<Randomised> profile =
                measure_profile(name, report);
            ASSERT_EQ(profile.size(), name.ends_with("leaf")
                                          ? 2
                                          : report.par().light.layers.size());
            double sum = 0;
            for (const auto& [estimated, values] : profile) {
                const Estimate again = estimate(values);
                EXPECT_NEAR(again.mean, estimated.mean, 1e-12) << name;
                // The error in a report contains what paths can tell.
                EXPECT_LE(again.standard_error,
                          estimated.standard_error * (1 + 1e-12))
                    << name;
                sum += estimated.mean;
            }
            EXPECT_GT(sum, .1) << name;
        }
        EXPECT_THROW(measure_profile("absorbed_by_hour", report), Error);
        EXPECT_THROW(measure_profile("lai", report), Error);
    }
    request.scene.components[0].photosynthesis.reset();
    EXPECT_THROW(measure_profile("assimilation_by_leaf", evaluated()), Error);
}

TEST_F(TwoLeaves, TheFormIsThatOfTheFullGrownPlant) {
    request.details.form = true;
    const auto number = [&](const char* name) {
        return measure_objective(name, evaluated()).estimate.mean;
    };
    // The stalk is the highest part; leaves stand at 40 and 30 degrees.
    EXPECT_NEAR(number("plant_height"), 2, 1e-12);
    EXPECT_NEAR(number("top_leaf_angle"), 35, 1e-12);
    Plant grown = *request.scene.components[0].plant;
    grown.stalk.height = 2.5;
    for (const double angle : {80., 20., 20., 20.})
        grown.leaves.push_back({.5, .06, angle, 40, 270, .5});
    request.scene.components[0].full_grown = grown;
    EXPECT_NEAR(number("plant_height"), 2.5, 1e-12);
    EXPECT_NEAR(number("top_leaf_angle"), 35, 1e-12);
}

TEST_F(TwoLeaves, EveryNumberIsKnownByRandomisation) {
    request.scene.components[0].photosynthesis.emplace();
    request.details.lines = {{{"leaf.length", "top", 1, 0.1}}, {}};
    request.details.form = true;
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        // Paths, caps and the balance of energy are of the method, and the
        // nearest line is a name; near infrared and shortwave need a band,
        // invasion two components, the light on panels panels, dead leaves and
        // carbon after silking plants that grow, and seven leaves that
        // exchange water.
        ASSERT_EQ(measure_numbers(report).size(),
                  objective_names().size() + 4 - 6 - 7);
        for (const auto& [quantity, estimated] : measure_numbers(report)) {
            const auto [same, values] =
                measure_objective(quantity.name, report);
            EXPECT_EQ(same.mean, estimated.mean);
            EXPECT_EQ(same.standard_error, estimated.standard_error);
            ASSERT_EQ(values.size(), 8u) << quantity.name;
            const auto [mean, error] = estimate(values);
            const double scale = std::abs(estimated.mean);
            EXPECT_NEAR(mean, estimated.mean, 1e-12 * scale) << quantity.name;
            EXPECT_NEAR(error, estimated.standard_error, 1e-9 * scale)
                << quantity.name;
            EXPECT_EQ(error > 1e-9 * scale,
                      quantity.certainty == Certainty::estimated)
                << quantity.name;
        }
    }
}

TEST_F(TwoLeaves, SaysWhichNumbersItDoesNotHave) {
    const CanopyReport dark = evaluated();
    EXPECT_THROW(measure_objective("sunlit_lai", dark), Error);
    EXPECT_THROW(measure_objective("absorbed_by_leaf", dark), Error);
    EXPECT_TRUE(is_of_assimilation("sunlit_lai"));
    EXPECT_FALSE(is_of_assimilation("fapar"));
}

TEST_F(TwoLeaves, WithoutSunAllFiguresAreZero) {
    request.scene.bands[0].light = illuminate({}, SkyModel::uniform, 90);
    const CanopyReport report = evaluated();
    EXPECT_EQ(report.par().light.day.leaves.mean, 0);
    EXPECT_EQ(report.par().light.day.leaves.standard_error, 0);
}

TEST_F(TwoLeaves, EachSunHasAPathHoweverFewThereAre) {
    const double usual = evaluated().par().light.day.leaves.mean;
    request.accuracy = {2, 64};
    const CanopyReport few = evaluated();
    const auto sources = request.scene.bands[0].light.light.sources.size();
    ASSERT_GT(sources, 10u);
    EXPECT_EQ(few.paths, 64 * sources);
    const Estimate& leaves = few.par().light.day.leaves;
    EXPECT_LT(std::abs(leaves.mean - usual), 4 * leaves.standard_error);
}

TEST_F(TwoLeaves, SheathsHaveOpticsOfTheirOwn) {
    Component& component = request.scene.components[0];
    Plant plant = *component.plant;
    plant.sheath = {true, 1, .001};
    set_plant(component, plant);
    Optics& optics = request.scene.bands[0].optics;
    optics = {};
    const CanopyReport black = evaluated();
    EXPECT_EQ(black.par().light.day.reflected.mean, 0);
    optics.materials = {{}, {}, {.9, 0}};
    const CanopyReport bright = evaluated();
    EXPECT_GT(bright.par().light.day.reflected.mean, 0);
    EXPECT_LT(bright.par().light.groups[3].mean,
              black.par().light.groups[3].mean / 5);
    EXPECT_EQ(bright.lai, black.lai);
}

TEST_F(TwoLeaves, AReadyFieldHasTheLightOfItsPlants) {
    const CanopyReport drawn = evaluated();
    request.scene =
        as_drawn(request.scene, draw_field(request.scene, request.randomness));
    for (const Fields fields : {Fields::one, Fields::each})
        EXPECT_EQ(evaluated(fields).par().budget_by_randomisation,
                  drawn.par().budget_by_randomisation);
}

TEST_F(TwoLeaves, LayersWithoutAThicknessReachTheTop) {
    request.layers = {0, 10};
    const CanopyReport report = evaluated();
    ASSERT_EQ(report.par().light.layers.size(), 10u);
    EXPECT_NEAR(report.layers.thickness, .2001, 1e-9);
    double leaves = 0;
    for (const Estimate& layer : report.par().light.layers)
        leaves += layer.mean;
    EXPECT_NEAR(leaves / report.par().light.day.leaves.mean, 1, 1e-12);
}

TEST_F(TwoLeaves, TheSunlitLeafAreaIsToldOnlyOnDemand) {
    const CanopyReport without = evaluated();
    EXPECT_FALSE(without.par().light.steps.front().sunlit);
    request.details.sunlit = true;
    const CanopyReport with = evaluated();
    ASSERT_TRUE(with.par().light.steps[6].sunlit);
    EXPECT_GT(with.par().light.steps[6].sunlit->mean, .3);
    EXPECT_EQ(with.par().budget_by_randomisation,
              without.par().budget_by_randomisation);
}

TEST_F(TwoLeaves, FirstHitsTellTheSunlitLeafAreaToo) {
    request = two_leaves({4096, 16});
    request.details.sunlit = true;
    request.scene.components[0].photosynthesis.emplace();
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        const auto& steps = request.scene.bands[0].light.series.steps;
        double mean = 0, seconds = 0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const Estimate hits = report.hit_by_sun->hours.at(i);
            const Estimate points = *report.par().light.steps[i].sunlit;
            EXPECT_NEAR(
                hits.mean, points.mean,
                4 * std::hypot(hits.standard_error, points.standard_error))
                << i;
            mean += steps[i].seconds * hits.mean;
            seconds += steps[i].seconds;
        }
        EXPECT_NEAR(report.hit_by_sun->mean.mean, mean / seconds, 1e-12);
        EXPECT_LT(report.hit_by_sun->mean.standard_error, .02);
    }
}

TEST_F(TwoLeaves, LeafAreaByLightSumsToAllLeafArea) {
    request.scene.components[0].photosynthesis.emplace();
    EXPECT_FALSE(evaluated().light_classes);
    request.details.sunlit = true;
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        const LightClassReport& all = report.light_classes.value();
        double sunlit = 0, shaded = 0, absorbed = 0;
        for (std::size_t c = 0; c < ppfd_classes; ++c) {
            sunlit += all.sunlit[c].mean;
            shaded += all.shaded[c].mean;
            absorbed += (all.sunlit[c].mean + all.shaded[c].mean) *
                        (class_begin(c) + (c < 2 ? 25 : 50));
        }
        EXPECT_NEAR((sunlit + shaded) / report.lai, 1, 1e-12);
        EXPECT_NEAR(sunlit / (report.hit_by_sun->mean.mean * report.lai), 1,
                    1e-12);
        // The middles of classes tell the light that leaves absorb.
        const double light = 4.57 * report.par().light.day.leaves.mean /
                             request.scene.bands[0].light.series.lit_seconds();
        EXPECT_NEAR(absorbed / light, 1, .05);
    }
}

TEST_F(TwoLeaves, AClockTimesGeometrySceneAndLightApart) {
    // Each look at it is a second later than the one before.
    double now = 100;
    const Clock clock = [&] { return now++; };
    request.accuracy = {64, 3, 0, 3};
    const Timing seconds = evaluate(request, device, clock).seconds;
    EXPECT_EQ(seconds.geometry, 3);
    EXPECT_EQ(seconds.scene, 3);
    EXPECT_EQ(seconds.light, 3);
    EXPECT_EQ(seconds.total(), 9);
    EXPECT_EQ(evaluated().seconds.total(), 0);
}

TEST_F(TwoLeaves, MoreEffortMakesTheLightOfASourceMoreCertain) {
    request.accuracy = {512, 64};
    const Estimate usual = evaluated().par().light.day.leaves_sky;
    for (Source& source : request.scene.bands[0].light.light.sources)
        if (!source.direction) source.effort = 8;
    const Estimate more = evaluated().par().light.day.leaves_sky;
    EXPECT_LT(more.standard_error, .7 * usual.standard_error);
    EXPECT_NEAR(more.mean, usual.mean,
                4 * std::hypot(more.standard_error, usual.standard_error));
}

//! A quarter turn of rows and sun together changes nothing but the axes.
TEST_F(TwoLeaves, SkiesOfInstantsFollowTheSunWithTheRows) {
    const auto leaves = [&](double rows, double sun) {
        const LightSeries day{{{12, 3600, {60, sun}, {0, 300}}}};
        request.scene.bands[0].light =
            illuminate(day, SkyModel::clear, rows, Skies::each);
        return evaluated().par().light.day.leaves.mean;
    };
    EXPECT_NEAR(leaves(0, 0) / leaves(90, 90), 1, 1e-12);
    EXPECT_GT(std::abs(leaves(0, 0) / leaves(90, 0) - 1), .005);
}

TEST_F(TwoLeaves, PartsOfAssimilationSumToTheWhole) {
    request.scene.components[0].photosynthesis.emplace();
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        const AssimilationReport& all = *report.assimilation;
        ASSERT_EQ(all.gross.tallies.size(), 8u);
        double leaves = 0, layers = 0, hours = 0;
        for (const Estimate& leaf : all.gross.groups) leaves += leaf.mean;
        for (const Estimate& layer : all.gross.layers) layers += layer.mean;
        const auto& steps = request.scene.bands[0].light.series.steps;
        for (std::size_t i = 0; i < steps.size(); ++i)
            hours += 1e-6 * steps[i].seconds * all.gross.hours[i].mean;
        EXPECT_GT(all.gross.sum.mean, .1);
        EXPECT_NEAR(leaves / all.gross.sum.mean, 1, 1e-12);
        EXPECT_NEAR(layers / all.gross.sum.mean, 1, 1e-12);
        EXPECT_NEAR(hours / all.gross.sum.mean, 1, 1e-12);
        EXPECT_LT(all.carbon_loss(), all.gross.sum.mean);
        EXPECT_GT(all.carbon_loss(), all.net_loss());
    }
}

TEST_F(TwoLeaves, AssimilationOfDaysAndHoursSumsToThatOfTheMeanDay) {
    request.scene.components[0].photosynthesis.emplace();
    request.scene.bands[0].light = illuminate(
        clear_days({"ames", 42, -93.6, -5},
                   {{{2025, 7, 7}, {2025, 8, 7}, {2025, 9, 20}}, 7, 20, 60},
                   .45),
        SkyModel::uniform, 90, Skies::shared, 2);
    const AssimilationReport all = *evaluated().assimilation;
    const LightSeries& series = request.scene.bands[0].light.series;
    ASSERT_EQ(all.gross.dates.size(), 3u);
    double days = 0, hours = 0;
    for (const Estimate& date : all.gross.dates) days += date.mean / 3;
    const auto steps = series.steps_of_hours();
    for (std::size_t h = 0; h < steps.size(); ++h)
        hours += 1e-6 * series.steps[steps[h].front()].seconds *
                 all.gross.hours[h].mean;
    EXPECT_NEAR(days / all.gross.sum.mean, 1, 1e-12);
    EXPECT_NEAR(hours / all.gross.sum.mean, 1, 1e-12);
    EXPECT_GT(all.gross.dates[0].mean, all.gross.dates[2].mean);
}

//! Returns a horizontal black leaf over all of the ground, in so many instants.
CanopyRequest black_sheet(const std::vector<TimeStep>& steps) {
    CanopyRequest request = two_leaves({64, 8});
    Scene& scene = request.scene;
    scene.components = {{.name = "sheet",
                         .mesh = {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                                  {{0, 1, 2, 3}},
                                  {0},
                                  {{"leaf01", {0, 0, 1}}}}}};
    scene.cell = {Boundary::periodic, 1, 1, 1};
    scene.photons = 1;
    request.scene.bands[0].light = illuminate({steps}, SkyModel::uniform, 90);
    scene.bands[0].optics = {};
    Photosynthesis& leaves =
        request.scene.components[0].photosynthesis.emplace();
    leaves.rates = {CollatzLeaf{}};
    leaves.profile = CapacityProfile::none;
    request.details.pieces = 1;
    return request;
}

TEST(BlackSheet, AssimilatesAsCollatzSaysInEachInstantsAir) {
    std::ifstream file(IDEOTYPE_TEST_DATA "/physiology/collatz.json");
    const nlohmann::json values = nlohmann::json::parse(file).at("fixed_ci");
    const Device device(Device::supported_isas().back());
    for (const bool is_beam : {true, false}) {
        std::vector<TimeStep> steps;
        double respired = 0;
        for (const nlohmann::json& each : values) {
            TimeStep step;
            step.hour = static_cast<double>(steps.size());
            step.seconds = 3600;
            step.sun = {40, 120};
            (is_beam ? step.par.beam : step.par.diffuse) = each.at("Q");
            step.temperature = each.at("T");
            step.humidity = each.at("vpd_rh");
            respired += 3600e-6 * each.at("Rd").get<double>();
            steps.push_back(step);
        }
        const AssimilationReport report =
            *evaluate(black_sheet(steps), device).assimilation;
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(report.gross.hours.at(i).mean, values[i].at("gross"),
                        1e-6)
                << i;
        EXPECT_NEAR(report.net_loss(), respired, 1e-12);
    }
}

TEST_F(TwoLeaves, LightDoesNotDependOnWhetherLeavesAssimilate) {
    const CanopyReport dark = evaluated();
    request.scene.components[0].photosynthesis.emplace();
    const CanopyReport report = evaluated();
    EXPECT_EQ(report.par().budget_by_randomisation,
              dark.par().budget_by_randomisation);
    ASSERT_EQ(report.groups.size(), dark.groups.size());
    for (std::size_t g = 0; g < dark.groups.size(); ++g) {
        EXPECT_NEAR(report.par().light.groups[g].mean,
                    dark.par().light.groups[g].mean,
                    1e-9 * dark.par().light.day.incident);
        EXPECT_EQ(report.groups[g].name, dark.groups[g].name);
    }
}

//! Plants that differ from each other, where even pieces of the same place do.
TEST_F(TwoLeaves, PiecesOfPlantsThatDifferAssimilateAsExactly) {
    request.scene.components[0].variation = {.15,  .15,  {15}, {20}, .1,
                                             {20}, {30}, {86}, .3,   .3};
    request.scene.components[0].photosynthesis.emplace();
    request.accuracy = {1 << 14, 16};
    const CanopyReport report = evaluated();
    request.details.exact = true;
    request.accuracy = {1 << 20, 16, 1e-3};
    const CanopyReport exact = evaluated();
    EXPECT_EQ(report.lai, exact.lai);
    EXPECT_LT(exact.assimilation->gross.sum.standard_error,
              1.5e-3 * exact.assimilation->gross.sum.mean);
    EXPECT_NEAR(report.assimilation->gross.sum.mean /
                    exact.assimilation->gross.sum.mean,
                1, .005);
}

TEST_F(TwoLeaves, PlantsThatDifferHaveTheMeanLeafAreaOfTheirFields) {
    const double line = evaluated().lai;
    request.scene.components[0].variation = {.length = .2, .width = .2};
    const double one = evaluated().lai;
    EXPECT_NE(one, line);
    EXPECT_NEAR(one, line, .3 * line);
    // 8 fields of 8 leaves.
    const CanopyReport many = evaluated(Fields::each);
    EXPECT_NEAR(many.lai, line, 3 * .3 * line / 8);
    EXPECT_NE(many.lai, one);
    request.randomness.generation = 1;
    EXPECT_NE(evaluated().lai, one);
}

//! The standard error knows of fields that differ more than their light does.
TEST_F(TwoLeaves, FieldsOfPlantsThatDifferAreLessCertain) {
    request.accuracy = {4096, 16};
    const Estimate alike = evaluated(Fields::each).par().light.day.leaves;
    request.scene.components[0].variation = {.2, .2, {15}, {30}, .1};
    const Estimate differing = evaluated(Fields::each).par().light.day.leaves;
    EXPECT_GT(differing.standard_error, 1.5 * alike.standard_error);
    EXPECT_LT(evaluated().par().light.day.leaves.standard_error,
              differing.standard_error / 2);
}

TEST_F(TwoLeaves, RandomisationsAreDividedAmongFields) {
    request.scene.components[0].photosynthesis.emplace();
    request.scene.components[0].variation = {.2, .2, {15}, {30}, .1};
    request.accuracy = {2048, 32, 0, 8};
    const CanopyReport report = evaluate(request, device);
    EXPECT_EQ(report.randomisations(), 8u);
    EXPECT_EQ(report.assimilation->gross.tallies.size(), 8u);
    EXPECT_EQ(report.paths, 2048u * 32u);
    const Estimate of_eight = report.par().light.day.leaves;
    const Estimate of_one = evaluated().par().light.day.leaves;
    const Estimate of_each = evaluated(Fields::each).par().light.day.leaves;
    EXPECT_GT(of_eight.standard_error, 1.5 * of_one.standard_error);
    EXPECT_NEAR(
        of_eight.mean, of_each.mean,
        4 * std::hypot(of_eight.standard_error, of_each.standard_error));
}

//! The error that fields add is no part of what a tolerance asks for.
TEST_F(TwoLeaves, AToleranceHoldsForAllFieldsTogether) {
    request.accuracy = {1 << 16, 16, .004};
    const std::uint64_t one = evaluate(request, device).paths;
    request.accuracy.fields = 4;
    const std::uint64_t four = evaluate(request, device).paths;
    EXPECT_LT(four, 2 * one);
    EXPECT_GT(4 * four, one);
}

TEST_F(TwoLeaves, AssimilationIsConcaveInLight) {
    request.scene.components[0].photosynthesis.emplace();
    const CanopyReport report = evaluated();
    const double linear = .06 * 4.57e-6 * report.par().light.day.leaves.mean;
    EXPECT_LT(report.assimilation->gross.sum.mean, .8 * linear);
    request.scene.components[0].photosynthesis->rates = {
        HyperbolaLeaf{{.06, 1, 1e9}, {}}};
    EXPECT_NEAR(evaluated().assimilation->gross.sum.mean / linear, 1, 1e-9);
}

}  // namespace
}  // namespace ideotype
