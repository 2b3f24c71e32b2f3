// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "field_of_two_leaves.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {
namespace {

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
    // The standard error estimated from eight randomisations is accurate to
    // about 25 %.
    EXPECT_LT(day.leaves.standard_error, .03 * day.leaves.mean);
    EXPECT_EQ(report.paths, 8u * 512u);
    EXPECT_NEAR(report.lai, .7455 * (.7 * .08 + .5 * .06) / (.76 * .15), .01);
    const double stalk = report.plant_area_index - report.lai;
    EXPECT_GT(stalk, 0);
    EXPECT_EQ(measure_objective("plant_area_index", report).estimate.mean,
              report.lai + stalk);
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
                // The standard error in a report includes the error due to the
                // number of paths.
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
    // The stalk is the highest part of the plant; the leaf angles are 40 and 30
    // deg.
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
        // Quantities with numbers that are not objectives: paths, caps, the
        // balance of energy, and the nearest line. Objectives without numbers
        // here require a further band (near infrared, shortwave), two
        // components (invasion), panels (their light), growth (dead leaves,
        // carbon after silking), exchange of water (seven), soil that dries
        // (seven), grain (four), or prices (three).
        ASSERT_EQ(measure_numbers(report).size(),
                  objective_names().size() + 4 - 6 - 7 - 7 - 4 - 3);
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
            // Leaves at air temperature respire in proportion to leaf area,
            // which is constant over all fields of uniform plants.
            const bool is_known = quantity.name == "respiration";
            EXPECT_EQ(error > 1e-9 * scale,
                      quantity.certainty == Certainty::estimated && !is_known)
                << quantity.name;
        }
    }
}

TEST_F(TwoLeaves, NumbersPerLeafAreaAreAsUncertainAsTheNumbers) {
    CanopyReport report = evaluated();
    // If randomisations agree by chance, their scatter is smaller than the
    // stated standard error.
    report.bands[0].light.day.leaves.standard_error *= 3;
    const Estimate whole = measure_objective("absorbed_par", report).estimate;
    const Estimate part =
        measure_objective("absorbed_par_per_leaf_area", report).estimate;
    EXPECT_NEAR(part.mean, whole.mean / report.lai, 1e-12 * part.mean);
    EXPECT_NEAR(part.standard_error, whole.standard_error / report.lai,
                1e-9 * part.mean);
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
    plant.sheath = {{}, true, 1, .001};
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

TEST_F(TwoLeaves, ThreadsThatShareFieldsFindTheSameBits) {
    request.scene.components[0].photosynthesis.emplace();
    request.scene.components[0].jitter = 45;
    const CanopyReport alone = evaluated(Fields::each);
    const CanopyReport shared = evaluate(request, device, {}, 3);
    EXPECT_EQ(shared.par().budget_by_randomisation,
              alone.par().budget_by_randomisation);
    for (const char* name : {"net_assimilation", "absorbed_par", "lai"})
        EXPECT_EQ(measure_objective(name, shared).by_randomisation,
                  measure_objective(name, alone).by_randomisation)
            << name;
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

TEST_F(TwoLeaves, TheSunlitLeafAreaIsReportedOnlyOnDemand) {
    const CanopyReport without = evaluated();
    EXPECT_FALSE(without.par().light.steps.front().sunlit);
    request.details.sunlit = true;
    const CanopyReport with = evaluated();
    ASSERT_TRUE(with.par().light.steps[6].sunlit);
    EXPECT_GT(with.par().light.steps[6].sunlit->mean, .3);
    EXPECT_EQ(with.par().budget_by_randomisation,
              without.par().budget_by_randomisation);
}

TEST_F(TwoLeaves, FirstHitsGiveTheSunlitLeafAreaToo) {
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
        // The sum over classes, each at its midpoint, agrees with the light
        // that leaves absorb.
        const double light = 4.57 * report.par().light.day.leaves.mean /
                             request.scene.bands[0].light.series.lit_seconds();
        EXPECT_NEAR(absorbed / light, 1, .05);
    }
}

TEST_F(TwoLeaves, AClockTimesGeometrySceneAndLightApart) {
    // This clock advances by one second each time it is read.
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

//! A quarter turn of the rows and the sun together only exchanges the axes.
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

}  // namespace
}  // namespace ideotype
