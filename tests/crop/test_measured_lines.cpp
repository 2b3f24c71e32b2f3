// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/measured_lines.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

//! Makes measured lines with two traits, the angle of the leaf below the
//! highest leaf and the height of the stalk. Their mean is the sample plant.
MeasuredLines two_traits(double correlation) {
    const Plant plant = sample_plant();
    return {
        {{"leaf.insertion_angle", "top-1", plant.leaves[1].insertion_angle, 5},
         {"stalk.height", "", plant.stalk.height, 0.2}},
        {correlation}};
}

TEST(MeasuredLines, MeanPlantHasNoDistance) {
    EXPECT_EQ(distance(two_traits(.5), sample_plant()).from_mean, 0);
}

TEST(MeasuredLines, DistanceIsInStandardDeviations) {
    Plant plant = sample_plant();
    plant.leaves[1].insertion_angle += 10;
    EXPECT_NEAR(distance(two_traits(0), plant).from_mean, 2, 1e-12);
    plant.stalk.height += 0.3;
    EXPECT_NEAR(distance(two_traits(0), plant).from_mean, 2.5, 1e-12);
    // For two correlated traits, d^2 = (a^2 - 2 r a b + b^2) / (1 - r^2).
    EXPECT_NEAR(distance(two_traits(.5), plant).from_mean,
                std::sqrt((4 - 3 + 2.25) / .75), 1e-12);
    EXPECT_NEAR(distance(two_traits(-.5), plant).from_mean,
                std::sqrt((4 + 3 + 2.25) / .75), 1e-12);
}

TEST(MeasuredLines, NearestLineIsIdentified) {
    MeasuredLines known = two_traits(0);
    const double angle = known.traits[0].mean, height = known.traits[1].mean;
    known.lines = {{"far", {angle + 20, height}},
                   {"near", {angle + 5, height}},
                   {"wide", {angle - 10, height}}};
    const LineDistance nearest = distance(known, sample_plant());
    EXPECT_EQ(nearest.line, 2u);
    EXPECT_NEAR(nearest.from_line, 1, 1e-12);
}

TEST(MeasuredLines, LeavesAreCountedFromTheEarOrTheTop) {
    Plant plant = sample_plant();
    for (std::size_t i = 0; i < 3; ++i)
        plant.leaves[i].insertion_angle = 10. * static_cast<double>(i);
    Organ ear;
    ear.name = "ear";
    ear.leaf = 2;
    plant.organs.push_back(ear);
    const auto angle = [&](const std::string& leaf) {
        return distance({{{"leaf.insertion_angle", leaf, 0, 1}}, {}}, plant)
            .from_mean;
    };
    EXPECT_EQ(angle("ear"), 10);
    EXPECT_EQ(angle("ear+1"), 20);
    EXPECT_EQ(angle("ear-7"), 0);  // no such leaf: the lowest one
    EXPECT_EQ(angle("top"), 20);
    EXPECT_EQ(angle("top-1"), 10);
    EXPECT_TRUE(names_leaf("ear-12"));
    for (const char* wrong : {"", "ea", "ear1x", "leaf3", "top+", "ear 1"})
        EXPECT_FALSE(names_leaf(wrong)) << wrong;
}

TEST(MeasuredLines, ImpossibleCorrelationsAreDetected) {
    MeasuredLines known = two_traits(0);
    EXPECT_TRUE(are_correlations(known));
    known.traits.push_back({"stalk.base_diameter", "", 0.02, 0.01});
    known.correlations = {.9, .9, -.9};
    EXPECT_FALSE(are_correlations(known));
}

TEST(MeasuredLines, UnknownMeasuresAreRefused) {
    EXPECT_THROW(
        distance({{{"spikelet.length", "", 0, 1}}, {}}, sample_plant()), Error);
}

}  // namespace
}  // namespace ideotype
