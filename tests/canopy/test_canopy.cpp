#include <gtest/gtest.h>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {
namespace {

const std::vector<LeafTraits> traits{{.7, .08, 40, 90}, {.5, .06, 30, 270}};

class TwoLeaves : public ::testing::Test {
  protected:
    TwoLeaves() {
        model.plant.leaves = {{60, .2}, {40, .5}};
        model.plant.blade.width_controls = {.28, .89, .9, 1.15, .38, 0};
        model.field.rows = model.field.plants = 2;
        model.field.spacing = {.76, .15, 90};
        model.optics = {{.05, .05}, {.31, .12}, .1};
        model.light = illuminate(
            clear_day({"ames", 42, -93.6, -5}, {{2025, 8, 7}, 7, 20, 60}, .45),
            SkyModel::uniform, 90);
        model.layers = {.25, 4};
    }

    CanopyReport evaluated(Draws::Fields fields = Draws::Fields::one) const {
        return study(model, device, traits, {1, 0, {512, 8}, fields},
                     Detail::history);
    }

    const Device device{Device::supported_isas().back()};
    CanopyModel model;
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
    EXPECT_LT(day.leaves.standard_error, .02 * day.leaves.mean);
    EXPECT_EQ(report.paths, 8u * 512u);
    EXPECT_NEAR(report.lai, .7455 * (.7 * .08 + .5 * .06) / (.76 * .15), .01);
}

TEST_F(TwoLeaves, AFieldForEachRandomisationAgreesWithOne) {
    const Estimate one = evaluated().light.day.leaves;
    const Estimate each = evaluated(Draws::Fields::each).light.day.leaves;
    EXPECT_NE(one.mean, each.mean);
    EXPECT_NEAR(one.mean / each.mean, 1, .05);
}

TEST_F(TwoLeaves, LeavesAreKnownByRandomisation) {
    for (const auto fields : {Draws::Fields::one, Draws::Fields::each}) {
        const CanopyReport report = evaluated(fields);
        ASSERT_EQ(report.leaves_by_randomisation.size(), 8u);
        const Estimate all = estimate(report.leaves_by_randomisation);
        const Estimate& leaves = report.light.day.leaves;
        EXPECT_NEAR(all.mean / leaves.mean, 1, 1e-12);
        EXPECT_NEAR(all.standard_error / leaves.standard_error, 1, 1e-9);
    }
}

TEST_F(TwoLeaves, WithoutSunAllFiguresAreZero) {
    model.light = illuminate({}, SkyModel::uniform, 90);
    const CanopyReport report = evaluated();
    EXPECT_EQ(report.light.day.leaves.mean, 0);
    EXPECT_EQ(report.light.day.leaves.standard_error, 0);
}

TEST_F(TwoLeaves, PlantsOfOtherNumbersOfLeavesAreRefused) {
    EXPECT_THROW(
        study(model, device, {traits[0]}, {1, 0, {64, 2}}, Detail::history),
        Error);
}

}  // namespace
}  // namespace ideotype
