// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/measures.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

Trait trait(const std::string& name, TraitNumbers numbers, TraitEffect effect,
            const std::vector<std::string>& measures) {
    Trait one;
    one.name = name;
    one.numbers = numbers;
    one.effect = effect;
    one.measures = measures;
    one.points = 3;
    return one;
}

const Crop crop{
    sample_plant(),
    {trait("length", TraitNumbers::leaf, TraitEffect::sets, {"leaf.length"}),
     trait("height", TraitNumbers::plant, TraitEffect::scales,
           {"stalk.height", "leaf.insertion_height"}),
     trait("angle", TraitNumbers::leaf, TraitEffect::sets,
           {"leaf.insertion_angle"}),
     trait("angles", TraitNumbers::profile, TraitEffect::shifts,
           {"leaf.insertion_angle"}),
     trait("diameter", TraitNumbers::plant, TraitEffect::sets,
           {"stalk.base_diameter"})}};

TEST(Crop, GenesAreTraitValuesOfLeavesThenOfThePlant) {
    const auto numbers = trait_numbers(crop);
    ASSERT_EQ(numbers.size(), 3 * 2 + 1 + 3 + 1u);
    EXPECT_EQ(numbers[0].trait, 0u);
    EXPECT_EQ(numbers[0].leaf, 1);
    EXPECT_EQ(numbers[1].trait, 2u);
    EXPECT_EQ(numbers[5].leaf, 3);
    EXPECT_EQ(numbers[6].trait, 1u);
    EXPECT_EQ(numbers[9].point, 3);
    EXPECT_EQ(numbers[10].trait, 4u);
}

TEST(Crop, BaselineTraitValuesReproduceTheBaseline) {
    const std::vector<double> baseline = baseline_numbers(crop);
    EXPECT_EQ(baseline, (std::vector<double>{.651, 34, .822, 24.5, .484, 80, 1,
                                             0, 0, 0, .027}));
    Plant again = grow(crop, baseline), plant = crop.baseline;
    const auto is = measures(again), was = measures(plant);
    for (std::size_t m = 0; m < was.size(); ++m)
        for (std::size_t i = 0; i < was[m].values.size(); ++i)
            EXPECT_EQ(*is[m].values[i], *was[m].values[i]) << was[m].name;
}

TEST(Crop, TraitsSetScaleAndShiftMeasures) {
    const Plant plant =
        grow(crop, {.7, 30, .8, 40, .9, 70, 1.5, 10, 0, -5, .02});
    EXPECT_EQ(plant.leaves[1].length, .8);
    EXPECT_EQ(plant.leaves[0].insertion_angle, 40);
    EXPECT_EQ(plant.leaves[1].insertion_angle, 40);
    EXPECT_EQ(plant.leaves[2].insertion_angle, 65);
    EXPECT_DOUBLE_EQ(plant.leaves[2].insertion_height, 2.4);
    EXPECT_DOUBLE_EQ(plant.stalk.height, 3);
    EXPECT_EQ(plant.stalk.base_diameter, .02);
    EXPECT_EQ(plant.leaves[1].width, crop.baseline.leaves[1].width);
}

TEST(Crop, MeasuresStayInTheirLimits) {
    const Plant plant = grow(crop, {.7, 30, .8, 40, .9, 80, 1, 0, 0, 50, .02});
    EXPECT_EQ(plant.leaves[2].insertion_angle, 90);
}

TEST(Crop, WrongGeneCountsAndUnknownMeasuresAreRefused) {
    EXPECT_THROW(grow(crop, {1, 2, 3}), Error);
    Crop wrong = crop;
    wrong.traits[0].measures = {"leaf.colour"};
    EXPECT_THROW(baseline_numbers(wrong), Error);
}

TEST(Profile, CurvePassesThroughItsValues) {
    const std::vector<double> values{1, 3, 2, 2.5};
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(profile(values, static_cast<double>(i) / 3), values[i],
                    1e-12);
    EXPECT_EQ(profile({7}, .3), 7);
    EXPECT_DOUBLE_EQ(profile({1, 2}, .25), 1.25);
}

// Expected values: scipy.interpolate.PchipInterpolator of SciPy 1.17.1 at 0.1,
// 0.3, 0.5 and 0.8.
TEST(Profile, CurveAgreesWithPchipOfSciPy) {
    const double expected[][4] = {
        {1.9464999999999997, 2.9755000000000003, 2.5, 2.056},
        {0.05600000000000001, 0.43200000000000005, 1.0, 2.512},
        {5.0, 5.0, 3.1999999999999997, 0.41759999999999975}};
    const std::vector<double> values[] = {
        {1, 3, 2, 2.5}, {0, 1, 4}, {5, 5, 1, 0}};
    const double at[] = {.1, .3, .5, .8};
    for (std::size_t v = 0; v < 3; ++v)
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(profile(values[v], at[i]), expected[v][i], 1e-12);
}

TEST(Profile, CurveStaysBetweenNeighbouringValues) {
    const std::vector<double> values{0, 1, 1, -2, 5};
    for (int k = 0; k <= 1000; ++k) {
        const double x = k / 1000., y = profile(values, x);
        const auto i =
            std::min<std::size_t>(static_cast<std::size_t>(4 * x), 3);
        EXPECT_GE(y, std::min(values[i], values[i + 1]) - 1e-12);
        EXPECT_LE(y, std::max(values[i], values[i + 1]) + 1e-12);
    }
}

}  // namespace
}  // namespace ideotype
