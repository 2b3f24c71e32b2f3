// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/measures.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

//! Makes a plant with blades that are longer below and shorter above, narrower
//! and more erect the denser it stands.
Plant plastic_plant() {
    Plant plant = sample_plant();
    plant.plasticity.reference = 6;
    plant.plasticity.responses = {
        {{"leaf.length"}, {}, {.1, 0, -.2}, {3, 12}},
        {{"leaf.width", "stalk.base_diameter"}, {}, {-.15}, {}},
        {{}, {"leaf.insertion_angle"}, {-4}, {}}};
    return plant;
}

TEST(Plasticity, HasNoEffectAtTheReferenceDensity) {
    Plant plant = plastic_plant();
    Plant same = respond(plant, 6);
    const auto is = measures(same), was = measures(plant);
    for (std::size_t m = 0; m < was.size(); ++m)
        for (std::size_t i = 0; i < was[m].values.size(); ++i)
            EXPECT_EQ(*is[m].values[i], *was[m].values[i]) << was[m].name;
    EXPECT_TRUE(same.plasticity.responses.empty());
}

TEST(Plasticity, PlantsWithoutResponsesAreTheSameAtAnyDensity) {
    Plant plant = sample_plant();
    Plant same = respond(plant, 30);
    EXPECT_EQ(same.leaves[0].length, plant.leaves[0].length);
    // Responses need a reference density.
    plant = plastic_plant();
    plant.plasticity.reference = 0;
    EXPECT_EQ(respond(plant, 30).leaves[0].length, plant.leaves[0].length);
}

TEST(Plasticity, ScalesAndShiftsMeasuresByTheLogarithmOfDensity) {
    const Plant was = plastic_plant(), is = respond(was, 9);
    const double d = 9 / 6.;
    EXPECT_DOUBLE_EQ(is.leaves[0].length,
                     was.leaves[0].length * std::pow(d, .1));
    EXPECT_DOUBLE_EQ(is.leaves[1].length, was.leaves[1].length);
    EXPECT_DOUBLE_EQ(is.leaves[2].length,
                     was.leaves[2].length * std::pow(d, -.2));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_DOUBLE_EQ(is.leaves[i].width,
                         was.leaves[i].width * std::pow(d, -.15));
        EXPECT_DOUBLE_EQ(is.leaves[i].insertion_angle,
                         was.leaves[i].insertion_angle - 4 * std::log(d));
    }
    EXPECT_DOUBLE_EQ(is.stalk.base_diameter,
                     was.stalk.base_diameter * std::pow(d, -.15));
}

TEST(Plasticity, KeepsTheNearestKnownValueOutsideItsDensities) {
    const Plant plant = plastic_plant();
    EXPECT_EQ(respond(plant, 40).leaves[2].length,
              respond(plant, 12).leaves[2].length);
    EXPECT_EQ(respond(plant, 1).leaves[2].length,
              respond(plant, 3).leaves[2].length);
    EXPECT_LT(respond(plant, 40).leaves[2].width,
              respond(plant, 12).leaves[2].width)
        << "this response is known at any density";
}

TEST(Plasticity, LeavesMeasuresWithinTheirLimits) {
    Plant plant = plastic_plant();
    plant.plasticity.responses = {{{}, {"leaf.insertion_angle"}, {-80}, {}}};
    for (const Leaf& leaf : respond(plant, 60).leaves)
        EXPECT_EQ(leaf.insertion_angle, 0);
}

TEST(Plasticity, UnknownMeasuresAreErrors) {
    Plant plant = plastic_plant();
    plant.plasticity.responses[0].scales = {"leaf.colour"};
    EXPECT_THROW(respond(plant, 9), Error);
}

TEST(Plasticity, InternodesThatRespondMoveAllLeavesAbove) {
    Plant plant = plastic_plant();
    for (Leaf& leaf : plant.leaves) leaf.internode = .2;
    plant.plasticity.responses = {{{"leaf.internode"}, {}, {.1}, {}}};
    stack_internodes(plant);
    const Plant is = respond(plant, 12);
    EXPECT_NEAR(is.leaves[2].insertion_height, .6 * std::pow(2, .1), 1e-12);
    EXPECT_NEAR(is.stalk.height, is.leaves[2].insertion_height, 1e-12);
}

TEST(Plasticity, LeavesTurnBetweenTwoDensities) {
    Plasticity plasticity;
    EXPECT_EQ(turn_at(plasticity, 9), 0);
    plasticity.turning = {4, 9};
    plasticity.turn = .6;
    EXPECT_EQ(turn_at(plasticity, 3), 0);
    EXPECT_EQ(turn_at(plasticity, 4), 0);
    EXPECT_DOUBLE_EQ(turn_at(plasticity, 6), .3) << "6 is the geometric mean";
    EXPECT_EQ(turn_at(plasticity, 9), .6);
    EXPECT_EQ(turn_at(plasticity, 20), .6);
}

//! Makes a crop with the slopes of a reaction norm of insertion angles as
//! traits.
Crop crop_with_norm() {
    Trait slope;
    slope.name = "angle_slope";
    slope.numbers = TraitNumbers::profile;
    slope.points = 2;
    slope.effect = TraitEffect::shifts;
    slope.measures = {"leaf.insertion_angle"};
    slope.is_slope = true;
    return {plastic_plant(), {slope}};
}

TEST(Plasticity, TraitsMayBeSlopesOfAReactionNorm) {
    const Crop norm = crop_with_norm();
    EXPECT_EQ(baseline_numbers(norm), (std::vector<double>{0, 0}));
    const Plant plain = grow(norm, {0, 0}), steeper = grow(norm, {-10, -2});
    EXPECT_EQ(plain.plasticity.responses.size(),
              norm.baseline.plasticity.responses.size());
    EXPECT_EQ(steeper.leaves[0].insertion_angle, 34)
        << "the slope has no effect at the reference";
    const double x = std::log(9 / 6.);
    const Plant is = respond(steeper, 9), was = respond(plain, 9);
    EXPECT_NEAR(is.leaves[0].insertion_angle,
                was.leaves[0].insertion_angle - 10 * x, 1e-12);
    EXPECT_NEAR(is.leaves[1].insertion_angle,
                was.leaves[1].insertion_angle - 6 * x, 1e-12);
    EXPECT_NEAR(is.leaves[2].insertion_angle,
                was.leaves[2].insertion_angle - 2 * x, 1e-12);
}

}  // namespace
}  // namespace ideotype
