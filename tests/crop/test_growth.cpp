// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <fstream>
#include <map>
#include <numeric>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ideotype/core/error.hpp"
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

TEST(Growth, GreenAreaTipsAndCollarsAgreeWithTheReference) {
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

TEST(Growth, DevelopmentIsOneAtSilkingAndTwoAtMaturity) {
    const double silking = silking_time(hybrid);
    EXPECT_EQ(development_stage(hybrid, -1), 0);
    EXPECT_EQ(development_stage(hybrid, silking / 2), 0.5);
    EXPECT_EQ(development_stage(hybrid, silking), 1);
    EXPECT_DOUBLE_EQ(
        development_stage(hybrid, silking + 0.75 * hybrid.maturity), 1.75);
    EXPECT_EQ(development_stage(hybrid, 1e5), 2);
    for (const double stage : {0., 0.3, 1., 1.4, 2.})
        EXPECT_DOUBLE_EQ(
            development_stage(hybrid, find_thermal_time(hybrid, stage)), stage);
}

TEST(Growth, LeavesAndOrgansAgeFromSilkingOn) {
    // Tables of WOFOST for temperate maize.
    Growth growth;
    growth.ageing = {1, 1, 0.9, 0.7, 0.3};
    growth.maintenance = {1, 1, 1, 0.75, 0.25};
    const std::map<double, std::pair<double, double>> factors{
        {0, {1, 1}},         {0.9, {1, 1}},       {1, {1, 1}},
        {1.25, {1, 1}},      {1.375, {0.95, 1}},  {1.5, {0.9, 1}},
        {1.75, {0.7, 0.75}}, {1.875, {0.5, 0.5}}, {2, {0.3, 0.25}}};
    for (const auto& [stage, factor] : factors) {
        const double time = find_thermal_time(growth, stage);
        EXPECT_NEAR(capacity_factor(growth, time), factor.first, 1e-12)
            << stage;
        EXPECT_NEAR(maintenance_factor(growth, time), factor.second, 1e-12)
            << stage;
    }
    EXPECT_EQ(capacity_factor(growth, 1e5), 0.3);
    // Without ageing all factors are exactly 1.
    for (double time = 0; time < 2500; time += 37) {
        EXPECT_EQ(capacity_factor(hybrid, time), 1);
        EXPECT_EQ(maintenance_factor(hybrid, time), 1);
    }
}

TEST(Growth, FadingMovesBladeAreaFromGreenToDead) {
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

TEST(Growth, StemsReachTheFinalCollarHeights) {
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

//! Returns the area of green or dead leaves in a mesh [m2].
double mesh_area(const Mesh& mesh, bool are_leaves) {
    double sum = 0;
    const std::vector<double> areas = face_areas(mesh);
    for (std::size_t f = 0; f < areas.size(); ++f)
        if (const Group& group = mesh.groups[mesh.face_group[f]];
            are_leaves ? group.id.is_leaf() : group.name == "stalk_dead_leaves")
            sum += areas[f];
    return sum;
}

TEST(Growth, MeshHasTheGreenAndDeadAreaOfThePlantAtEveryAge) {
    const Plant plant = complete_plant(hybrid, sample_plant());
    ASSERT_EQ(plant.leaves.size(), 19u);
    // The area of a complete blade is 0.7455 length x width.
    const std::vector<LeafDates> dates = leaf_dates(hybrid);
    for (const double tau : {60., 300., 700., 887., 1100., 1500., 2100.}) {
        double green = 0, dead = 0;
        for (std::size_t i = 0; i < dates.size(); ++i) {
            const Leaf& leaf = plant.leaves[i];
            const double area = 0.7455 * leaf.length * leaf.width *
                                visible_share(dates[i], tau);
            const double faded = faded_share(hybrid, dates[i], tau);
            green += area * (1 - faded);
            dead += area * faded;
        }
        const Mesh mesh =
            build_plant(age_plant(hybrid, sample_plant(), tau), {48, 8});
        EXPECT_NEAR(mesh_area(mesh, true) / green, 1, 0.01) << tau;
        EXPECT_NEAR(mesh_area(mesh, false), dead, 0.01 * (green + dead)) << tau;
    }
}

TEST(Growth, PlantWithAllLeavesGreenEqualsTheFullGrownPlantBitForBit) {
    Growth growth = hybrid;
    growth.leaves = 3;
    growth.lower_death = 3000;
    growth.upper_death = 3000;
    Plant plant = sample_plant();
    plant.organs.push_back({{}, "ear", true, PlantMaterial::stalk, 2});
    plant.organs.back().length = 0.2;
    plant.organs.back().base_diameter = 0.02;
    const Mesh grown = build_plant(plant, {});
    const Mesh at = build_plant(age_plant(growth, plant, 2000), {});
    EXPECT_EQ(at.vertices, grown.vertices);
    EXPECT_EQ(at.faces, grown.faces);
    EXPECT_EQ(at.face_group, grown.face_group);
    const Mesh young = build_plant(age_plant(growth, plant, 100), {});
    EXPECT_NE(young.vertices, grown.vertices);
}

TEST(Growth, TasselDiesAtItsSenescence) {
    Plant plant = sample_plant();
    Organ tassel;
    tassel.material = PlantMaterial::sheath;
    tassel.length = tassel.base_diameter = 0.1;
    tassel.capacity = 0.1;
    tassel.maintenance = 0.015;
    tassel.senescence = 100;
    plant.organs = {tassel};
    const double silking = silking_time(hybrid);
    const Organ green = age_plant(hybrid, plant, silking + 99).organs[0];
    EXPECT_EQ(green.material, PlantMaterial::sheath);
    EXPECT_EQ(green.capacity, 0.1);
    const Organ dead = age_plant(hybrid, plant, silking + 100).organs[0];
    EXPECT_EQ(dead.material, PlantMaterial::stalk);
    EXPECT_EQ(dead.capacity, 0);
    EXPECT_EQ(dead.maintenance, 0);
}

TEST(Growth, PlantWithMoreLeavesThanGrowthIsRefused) {
    Growth growth = hybrid;
    growth.leaves = 2;
    const Plant plant = sample_plant();
    ASSERT_GT(plant.leaves.size(), 2u);
    EXPECT_THROW(age_plant(growth, plant, 500), Error);
    EXPECT_THROW(complete_plant(growth, plant), Error);
    growth.leaves = static_cast<int>(plant.leaves.size());
    EXPECT_EQ(age_plant(growth, plant, 500).leaves.size(), plant.leaves.size());
}

TEST(Growth, UnfoldingBladeIsErectAndKeepsItsTip) {
    const LeafDates dates = leaf_dates(hybrid)[18];
    const double half = (dates.tip + dates.collar) / 2;
    const Plant young = age_plant(hybrid, sample_plant(), half);
    const Leaf leaf = young.leaves[18], grown = sample_plant().leaves[2];
    EXPECT_NEAR(leaf.insertion_angle, grown.insertion_angle * 0.65, 1e-12);
    EXPECT_GT(leaf.hidden, 0.2);
    EXPECT_LT(leaf.hidden, 0.6);
    EXPECT_EQ(leaf.length, grown.length);
    EXPECT_LT(young.stalk.height, sample_plant().stalk.height);
    EXPECT_EQ(age_plant(hybrid, sample_plant(), 0).leaves[18].hidden, 1);
}

TEST(Growth, DailyThermalTimeIsTheHourlyMeanBetweenBaseAndCap) {
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
