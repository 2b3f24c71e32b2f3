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

using Fields = Randomness::Fields;

class TwoLeaves : public ::testing::Test {
  protected:
    CanopyReport evaluated(Fields fields = Fields::one) {
        request.randomness.fields = fields;
        return evaluate(request, device);
    }

    const Device device{Device::supported_isas().back()};
    CanopyRequest request = two_leaves({512, 8});
};

TEST_F(TwoLeaves, PartsOfTheLightSumToWhatFalls) {
    const CanopyReport report = evaluated();
    const BudgetEstimate& day = report.light.day;
    EXPECT_NEAR((day.leaves.mean + day.stalks.mean + day.soil.mean +
                 day.reflected.mean) /
                    day.incident,
                1, 1e-12);
    double leaves = 0;
    for (const Estimate& layer : report.light.layers) leaves += layer.mean;
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
    const Estimate one = evaluated().light.day.leaves;
    const Estimate each = evaluated(Fields::each).light.day.leaves;
    EXPECT_NE(one.mean, each.mean);
    EXPECT_NEAR(one.mean / each.mean, 1, .05);
}

TEST_F(TwoLeaves, ProfilesAreKnownByRandomisation) {
    request.details.photosynthesis.emplace();
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        for (const std::string name :
             {"absorbed_by_leaf", "absorbed_by_layer", "assimilation_by_leaf",
              "net_assimilation_by_leaf", "assimilation_by_layer"}) {
            const std::vector<Randomised> profile =
                measure_profile(name, report);
            ASSERT_EQ(profile.size(),
                      name.ends_with("leaf") ? 2 : report.light.layers.size());
            double sum = 0;
            for (const auto& [estimated, values] : profile) {
                const Estimate again = estimate(values);
                EXPECT_NEAR(again.mean, estimated.mean, 1e-12) << name;
                // That of a report knows what paths can tell.
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
    request.details.photosynthesis.reset();
    EXPECT_THROW(measure_profile("assimilation_by_leaf", evaluated()), Error);
}

TEST_F(TwoLeaves, EveryNumberIsKnownByRandomisation) {
    request.details.photosynthesis.emplace();
    request.details.lines = {{{"leaf.length", "top", 1, 0.1}}, {}};
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        // Paths, caps and the balance of energy are of the method, and the
        // nearest line is a name.
        ASSERT_EQ(measure_numbers(report).size(), objective_names().size() + 4);
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
    request.scenario.light = illuminate({}, SkyModel::uniform, 90);
    const CanopyReport report = evaluated();
    EXPECT_EQ(report.light.day.leaves.mean, 0);
    EXPECT_EQ(report.light.day.leaves.standard_error, 0);
}

TEST_F(TwoLeaves, EachSunHasAPathHoweverFewThereAre) {
    const double usual = evaluated().light.day.leaves.mean;
    request.accuracy = {2, 64};
    const CanopyReport few = evaluated();
    const auto sources = request.scenario.light.light.sources.size();
    ASSERT_GT(sources, 10u);
    EXPECT_EQ(few.paths, 64 * sources);
    const Estimate& leaves = few.light.day.leaves;
    EXPECT_LT(std::abs(leaves.mean - usual), 4 * leaves.standard_error);
}

TEST_F(TwoLeaves, SheathsHaveOpticsOfTheirOwn) {
    Plant& plant = std::get<Plant>(request.stand);
    plant.sheath = {true, 1, .001};
    request.scenario.optics.soil_albedo = 0;
    request.scenario.optics.leaf = request.scenario.optics.stalk = {};
    request.scenario.optics.sheath = {};
    const CanopyReport black = evaluated();
    EXPECT_EQ(black.light.day.reflected.mean, 0);
    request.scenario.optics.sheath = {.9, 0};
    const CanopyReport bright = evaluated();
    EXPECT_GT(bright.light.day.reflected.mean, 0);
    EXPECT_LT(bright.light.groups[3].mean, black.light.groups[3].mean / 5);
    EXPECT_EQ(bright.lai, black.lai);
}

TEST_F(TwoLeaves, AReadyFieldHasTheLightOfItsPlants) {
    const CanopyReport drawn = evaluated();
    request.stand = draw_field(build_plant(std::get<Plant>(request.stand), {}),
                               request.scenario.field, request.randomness);
    for (const Fields fields : {Fields::one, Fields::each})
        EXPECT_EQ(evaluated(fields).budget_by_randomisation,
                  drawn.budget_by_randomisation);
}

TEST_F(TwoLeaves, LayersWithoutAThicknessReachTheTop) {
    request.layers = {0, 10};
    const CanopyReport report = evaluated();
    ASSERT_EQ(report.light.layers.size(), 10u);
    EXPECT_NEAR(report.layers.thickness, .2001, 1e-9);
    double leaves = 0;
    for (const Estimate& layer : report.light.layers) leaves += layer.mean;
    EXPECT_NEAR(leaves / report.light.day.leaves.mean, 1, 1e-12);
}

TEST_F(TwoLeaves, TheSunlitLeafAreaIsToldOnlyOnDemand) {
    const CanopyReport without = evaluated();
    EXPECT_FALSE(without.light.steps.front().sunlit);
    request.details.sunlit = true;
    const CanopyReport with = evaluated();
    ASSERT_TRUE(with.light.steps[6].sunlit);
    EXPECT_GT(with.light.steps[6].sunlit->mean, .3);
    EXPECT_EQ(with.budget_by_randomisation, without.budget_by_randomisation);
}

TEST_F(TwoLeaves, FirstHitsTellTheSunlitLeafAreaToo) {
    request = two_leaves({4096, 16});
    request.details = {.sunlit = true, .photosynthesis = Photosynthesis{}};
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        const auto& steps = request.scenario.light.series.steps;
        double mean = 0, seconds = 0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const Estimate hits = report.hit_by_sun->hours.at(i);
            const Estimate points = *report.light.steps[i].sunlit;
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
    request.details.photosynthesis.emplace();
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
        const double light = 4.57 * report.light.day.leaves.mean /
                             request.scenario.light.series.lit_seconds();
        EXPECT_NEAR(absorbed / light, 1, .05);
    }
}

TEST_F(TwoLeaves, AClockTimesGeometrySceneAndLightApart) {
    // Each look at it is a second later than the one before.
    double now = 100;
    const Clock clock = [&] { return now++; };
    request.accuracy = {64, 3};
    request.randomness.fields = Fields::each;
    const Timing seconds = evaluate(request, device, clock).seconds;
    EXPECT_EQ(seconds.geometry, 3);
    EXPECT_EQ(seconds.scene, 3);
    EXPECT_EQ(seconds.light, 3);
    EXPECT_EQ(seconds.total(), 9);
    EXPECT_EQ(evaluated().seconds.total(), 0);
}

TEST_F(TwoLeaves, MoreEffortMakesTheLightOfASourceMoreCertain) {
    request.accuracy = {512, 64};
    const Estimate usual = evaluated().light.day.leaves_sky;
    for (Source& source : request.scenario.light.light.sources)
        if (!source.direction) source.effort = 8;
    const Estimate more = evaluated().light.day.leaves_sky;
    EXPECT_LT(more.standard_error, .7 * usual.standard_error);
    EXPECT_NEAR(more.mean, usual.mean,
                4 * std::hypot(more.standard_error, usual.standard_error));
}

//! A quarter turn of rows and sun together changes nothing but the axes.
TEST_F(TwoLeaves, SkiesOfInstantsFollowTheSunWithTheRows) {
    const auto leaves = [&](double rows, double sun) {
        const LightSeries day{{{12, 3600, {60, sun}, {0, 300}}}};
        request.scenario.light =
            illuminate(day, SkyModel::clear, rows, Skies::each);
        return evaluated().light.day.leaves.mean;
    };
    EXPECT_NEAR(leaves(0, 0) / leaves(90, 90), 1, 1e-12);
    EXPECT_GT(std::abs(leaves(0, 0) / leaves(90, 0) - 1), .005);
}

TEST_F(TwoLeaves, PartsOfAssimilationSumToTheWhole) {
    request.details.photosynthesis.emplace();
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        const AssimilationReport& all = *report.assimilation;
        ASSERT_EQ(all.tallies.size(), 8u);
        double leaves = 0, layers = 0, hours = 0;
        for (const Estimate& leaf : all.groups) leaves += leaf.mean;
        for (const Estimate& layer : all.layers) layers += layer.mean;
        const auto& steps = request.scenario.light.series.steps;
        for (std::size_t i = 0; i < steps.size(); ++i)
            hours += 1e-6 * steps[i].seconds * all.hours[i].mean;
        EXPECT_GT(all.gross.mean, .1);
        EXPECT_NEAR(leaves / all.gross.mean, 1, 1e-12);
        EXPECT_NEAR(layers / all.gross.mean, 1, 1e-12);
        EXPECT_NEAR(hours / all.gross.mean, 1, 1e-12);
        EXPECT_LT(all.carbon_loss(), all.gross.mean);
        EXPECT_GT(all.carbon_loss(), all.net_loss());
    }
}

TEST_F(TwoLeaves, AssimilationOfDaysAndHoursSumsToThatOfTheMeanDay) {
    request.details.photosynthesis.emplace();
    request.scenario.light = illuminate(
        clear_days({"ames", 42, -93.6, -5},
                   {{{2025, 7, 7}, {2025, 8, 7}, {2025, 9, 20}}, 7, 20, 60},
                   .45),
        SkyModel::uniform, 90, Skies::shared, 2);
    const AssimilationReport all = *evaluated().assimilation;
    const LightSeries& series = request.scenario.light.series;
    ASSERT_EQ(all.dates.size(), 3u);
    double days = 0, hours = 0;
    for (const Estimate& date : all.dates) days += date.mean / 3;
    const auto steps = series.steps_of_hours();
    for (std::size_t h = 0; h < steps.size(); ++h)
        hours +=
            1e-6 * series.steps[steps[h].front()].seconds * all.hours[h].mean;
    EXPECT_NEAR(days / all.gross.mean, 1, 1e-12);
    EXPECT_NEAR(hours / all.gross.mean, 1, 1e-12);
    EXPECT_GT(all.dates[0].mean, all.dates[2].mean);
}

//! A horizontal black leaf over all of the ground, in so many instants.
CanopyRequest black_sheet(const std::vector<TimeStep>& steps) {
    Field field;
    field.mesh.vertices = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    field.mesh.faces = {{0, 1, 2, 3}};
    field.mesh.face_group = {0};
    field.mesh.groups = {{"leaf01", Tissue::leaf}};
    field.period_x = field.period_y = field.ground_area = 1;
    CanopyRequest request = two_leaves({64, 8});
    request.stand = field;
    request.scenario.light = illuminate({steps}, SkyModel::uniform, 90);
    request.scenario.optics = {};
    Photosynthesis& leaves = request.details.photosynthesis.emplace();
    leaves.rates = {CollatzLeaf{}};
    leaves.profile = CapacityProfile::none;
    leaves.photons = 1;
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
            EXPECT_NEAR(report.hours.at(i).mean, values[i].at("gross"), 1e-6)
                << i;
        EXPECT_NEAR(report.net_loss(), respired, 1e-12);
    }
}

TEST_F(TwoLeaves, LightDoesNotDependOnWhetherLeavesAssimilate) {
    const CanopyReport dark = evaluated();
    request.details.photosynthesis.emplace();
    const CanopyReport report = evaluated();
    EXPECT_EQ(report.budget_by_randomisation, dark.budget_by_randomisation);
    ASSERT_EQ(report.groups.size(), dark.groups.size());
    for (std::size_t g = 0; g < dark.groups.size(); ++g) {
        EXPECT_NEAR(report.light.groups[g].mean, dark.light.groups[g].mean,
                    1e-9 * dark.light.day.incident);
        EXPECT_EQ(report.groups[g].name, dark.groups[g].name);
    }
}

//! Plants that differ from each other, where even pieces of the same place do.
TEST_F(TwoLeaves, PiecesOfPlantsThatDifferAssimilateAsExactly) {
    request.scenario.field.variation = {.15,  .15,  {15}, {20}, .1,
                                        {20}, {30}, {86}, .3,   .3};
    request.details.photosynthesis.emplace();
    request.accuracy = {1 << 14, 16};
    const CanopyReport report = evaluated();
    request.details.exact = true;
    request.accuracy = {1 << 20, 16, 1e-3};
    const CanopyReport exact = evaluated();
    EXPECT_EQ(report.lai, exact.lai);
    EXPECT_LT(exact.assimilation->gross.standard_error,
              1.5e-3 * exact.assimilation->gross.mean);
    EXPECT_NEAR(
        report.assimilation->gross.mean / exact.assimilation->gross.mean, 1,
        .005);
}

TEST_F(TwoLeaves, PlantsThatDifferHaveTheMeanLeafAreaOfTheirFields) {
    const double line = evaluated().lai;
    request.scenario.field.variation = {.length = .2, .width = .2};
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
    const Estimate alike = evaluated(Fields::each).light.day.leaves;
    request.scenario.field.variation = {.2, .2, {15}, {30}, .1};
    const Estimate differing = evaluated(Fields::each).light.day.leaves;
    EXPECT_GT(differing.standard_error, 1.5 * alike.standard_error);
    EXPECT_LT(evaluated().light.day.leaves.standard_error,
              differing.standard_error / 2);
}

TEST_F(TwoLeaves, AssimilationIsConcaveInLight) {
    request.details.photosynthesis.emplace();
    const CanopyReport report = evaluated();
    const double linear = .06 * 4.57e-6 * report.light.day.leaves.mean;
    EXPECT_LT(report.assimilation->gross.mean, .8 * linear);
    request.details.photosynthesis->rates = {HyperbolaLeaf{{.06, 1, 1e9}, {}}};
    EXPECT_NEAR(evaluated().assimilation->gross.mean / linear, 1, 1e-9);
}

}  // namespace
}  // namespace ideotype
