// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <fstream>
#include <numeric>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ideotype/crop/growth.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

const Growth hybrid;

double green_area(double thermal_time) {
    double sum = 0;
    for (const LeafDates& leaf : leaf_dates(hybrid))
        sum += blade_area(hybrid, leaf, thermal_time).green;
    return sum;
}

TEST(Growth, HasTheGreenAreaTipsAndCollarsOfTheReference) {
    std::ifstream file(IDEOTYPE_TEST_DATA "/growth/growth_given.json");
    const auto given = nlohmann::json::parse(file);
    EXPECT_EQ(silking_time(hybrid), given["silking"]);
    EXPECT_EQ(maturity_time(hybrid), given["maturity"]);
    ASSERT_EQ(given["cases"].size(), 17u);
    for (const auto& one : given["cases"]) {
        const double tau = one["tau"];
        EXPECT_NEAR(green_area(tau), one["green_area"].get<double>(), 1e-6)
            << tau;
        int tips = 0, collars = 0;
        for (const LeafDates& leaf : leaf_dates(hybrid)) {
            tips += leaf.tip <= tau ? 1 : 0;
            collars += leaf.collar <= tau ? 1 : 0;
        }
        EXPECT_EQ(tips, one["tips"].get<int>()) << tau;
        EXPECT_EQ(collars, one["collars"].get<int>()) << tau;
    }
}

TEST(Growth, ABladeIsGreenAndThenDeadAndKeepsItsArea) {
    const LeafDates leaf = leaf_dates(hybrid)[11];
    EXPECT_EQ(blade_area(hybrid, leaf, leaf.tip).green, 0);
    EXPECT_EQ(blade_area(hybrid, leaf, leaf.collar).green, leaf.area);
    const BladeArea half =
        blade_area(hybrid, leaf, leaf.death + hybrid.fading / 2);
    EXPECT_NEAR(half.green, leaf.area / 2, 1e-15);
    EXPECT_NEAR(half.green + half.dead, leaf.area, 1e-15);
    EXPECT_EQ(blade_area(hybrid, leaf, 1e4).green, 0);
    EXPECT_EQ(blade_area(hybrid, leaf, 1e4).dead, leaf.area);
}

TEST(Growth, StemsGrowToTheHeightsOfThePlant) {
    const Plant plant = sample_plant();
    const std::vector<double> final_heights =
        final_collar_heights(hybrid, plant);
    ASSERT_EQ(final_heights.size(), 19u);
    EXPECT_EQ(final_heights.back(), plant.leaves.back().insertion_height);
    const auto at = [&](double tau) {
        return collar_heights(hybrid, final_heights, .18, tau);
    };
    for (const double height : at(0)) EXPECT_EQ(height, 0);
    const std::vector<double> grown = at(1e4);
    for (std::size_t i = 0; i < grown.size(); ++i)
        EXPECT_NEAR(grown[i], final_heights[i], 1e-12) << i;
    double before = 0;
    for (double tau = 0; tau < 1200; tau += 10) {
        const double top = at(tau).back();
        EXPECT_GE(top, before);
        before = top;
    }
}

TEST(Growth, ThermalTimeIsTheMeanOfHoursBetweenBaseAndCap) {
    std::array<double, 24> hours{};
    hours.fill(5);
    EXPECT_EQ(daily_thermal_time(hybrid, hours), 0);
    hours.fill(20);
    EXPECT_EQ(daily_thermal_time(hybrid, hours), 12);
    hours.fill(40);
    EXPECT_EQ(daily_thermal_time(hybrid, hours), 26);
    hours.fill(20);
    hours[0] = 44;
    EXPECT_NEAR(daily_thermal_time(hybrid, hours), 12 + 14 / 24., 1e-12);
    EXPECT_EQ(daily_thermal_time(hybrid, {}), 0);
}

}  // namespace
}  // namespace ideotype
