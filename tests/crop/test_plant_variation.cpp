// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/core/estimate.hpp"
#include "ideotype/crop/plant_variation.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

RandomStream stream(std::uint64_t seed = 1) {
    return {seed, Purpose::variation};
}

//! The mean and standard deviation of a measure over many plants.
struct Spread {
    double mean, deviation;
};

template <class Measure>
Spread estimate_spread(const PlantVariation& variation, Measure measure) {
    constexpr int plants = 4000;
    RandomStream random = stream();
    std::vector<double> values;
    for (int i = 0; i < plants; ++i)
        values.push_back(measure(deviating(sample_plant(), variation, random)));
    const Estimate mean = estimate(values);
    return {mean.mean, mean.standard_error * std::sqrt(plants)};
}

TEST(PlantVariation, PlantsHaveTheGivenMeansAndDeviations) {
    const PlantVariation variation{.1,  .2,   {8},        {15},
                                   .05, {12}, {1, 20, 1}, {86}};
    const Plant line = sample_plant();
    const auto expect = [&](auto measure, double mean, double deviation) {
        const Spread spread = estimate_spread(variation, measure);
        EXPECT_NEAR(spread.mean, mean, .07 * deviation);
        EXPECT_NEAR(spread.deviation / deviation, 1, .04);
    };
    const Leaf& second = line.leaves[1];
    expect([](const Plant& p) { return p.leaves[1].length; }, second.length,
           .1 * second.length);
    expect([](const Plant& p) { return p.leaves[1].width; }, second.width,
           .2 * second.width);
    expect([](const Plant& p) { return p.leaves[1].insertion_angle; },
           second.insertion_angle, 8);
    expect([](const Plant& p) { return p.leaves[1].azimuth; }, second.azimuth,
           15);
    expect([](const Plant& p) { return p.leaves[1].insertion_height; },
           second.insertion_height, .05 * second.insertion_height);
    expect([](const Plant& p) { return p.leaves[1].curvature; },
           second.curvature, 12);
    // With three leaves, the second leaf is the middle third.
    expect([](const Plant& p) { return p.leaves[1].roll; }, 0, 20);
    expect([](const Plant& p) { return p.leaves[2].roll; }, 0, 1);
    expect([](const Plant& p) { return p.stalk.height; }, line.stalk.height,
           .05 * line.stalk.height);
}

TEST(PlantVariation, ZeroVariationLeavesThePlantUnchanged) {
    RandomStream random = stream();
    const Plant line = sample_plant();
    const Plant same = deviating(line, {}, random);
    for (std::size_t i = 0; i < line.leaves.size(); ++i) {
        EXPECT_EQ(same.leaves[i].length, line.leaves[i].length);
        EXPECT_EQ(same.leaves[i].insertion_angle,
                  line.leaves[i].insertion_angle);
        EXPECT_EQ(same.leaves[i].azimuth, line.leaves[i].azimuth);
    }
    EXPECT_FALSE(PlantVariation{}.is_any());
    EXPECT_TRUE((PlantVariation{.azimuth = {0, 1}}.is_any()));
}

TEST(PlantVariation, VariationOfOneMeasureKeepsRandomNumbersOfTheOthers) {
    RandomStream few = stream(), many = stream();
    const PlantVariation only{.length = .1}, more{.1, .1, {8}, {8}, .1};
    for (int i = 0; i < 5; ++i) {
        const Plant a = deviating(sample_plant(), only, few);
        const Plant b = deviating(sample_plant(), more, many);
        for (std::size_t leaf = 0; leaf < a.leaves.size(); ++leaf)
            EXPECT_EQ(a.leaves[leaf].length, b.leaves[leaf].length);
        EXPECT_NE(a.leaves[0].width, b.leaves[0].width);
    }
}

TEST(PlantVariation, NoLeafLeansToTheOppositeSideOfTheStalk) {
    Plant upright = sample_plant();
    for (Leaf& leaf : upright.leaves) leaf.insertion_angle = 2;
    RandomStream random = stream();
    for (int i = 0; i < 100; ++i)
        for (const Leaf& leaf :
             deviating(upright, {.insertion_angle = {10}}, random).leaves)
            EXPECT_GE(leaf.insertion_angle, 0);
}

TEST(PlantVariation, TwistIsSmallForMostBladesAndLargeForSome) {
    // The standard deviation is 86 deg as measured, and 43 deg for half of the
    // plants.
    RandomStream random = stream();
    std::vector<double> sizes;
    double squares = 0;
    for (int i = 0; i < 4000; ++i) {
        const Plant plant = deviating(sample_plant(), {.twist = {86}}, random);
        sizes.push_back(std::abs(plant.leaves[0].twist));
        squares += std::pow(sizes.back(), 2);
    }
    std::nth_element(sizes.begin(), sizes.begin() + 2000, sizes.end());
    EXPECT_NEAR(sizes[2000], 43, 2.5);
    EXPECT_NEAR(std::sqrt(squares / 4000), 86, 5);
    EXPECT_LE(*std::max_element(sizes.begin(), sizes.end()), 3 * 86);
}

TEST(PlantVariation, ScaledPlantsAreSimilar) {
    const Plant line = sample_plant();
    const Plant half = scaled(line, 0.5);
    EXPECT_NEAR(plant_area(build_plant(half, {})).leaves,
                plant_area(build_plant(line, {})).leaves / 4, 1e-9);
    EXPECT_EQ(half.stalk.height, line.stalk.height / 2);
    EXPECT_EQ(half.leaves[0].azimuth, line.leaves[0].azimuth);
}

TEST(PlantVariation, PlantsHaveTheFacesOfTheirLine) {
    // Each sheath ends where the leaf below is inserted, up to rounding, or
    // some micrometres above, as where an internode has just begun to grow.
    for (const double bare : {0., 5e-7, 1e-6, 1.5e-6, 3e-6}) {
        Plant line = sample_plant();
        line.stalk.base_diameter = .02;
        line.sheath = {{}, true, .18, .001};
        line.sheath.capacity = .1;
        line.leaves[0].insertion_height = 1.06;
        line.leaves[1].insertion_height = 1.24 + bare;
        line.leaves[2].insertion_height = 1.42 + 2 * bare;
        line.stalk.height = 1.42 + 2 * bare;
        const Mesh mesh = build_plant(line, {});
        RandomStream random = stream();
        for (int i = 0; i < 200; ++i)
            EXPECT_EQ(
                build_plant(deviating(line, {.height = .05}, random), {}).faces,
                mesh.faces)
                << bare;
        EXPECT_EQ(build_plant(scaled(line, .7), {}).faces, mesh.faces) << bare;
    }
}

}  // namespace
}  // namespace ideotype
