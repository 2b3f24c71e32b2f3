// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/leaf_surface.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

double distance(const glm::dvec3& a, const glm::dvec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

double blade_width(const BladeRow& row) {
    return distance(row.left, row.midrib) + distance(row.midrib, row.right);
}

LeafSurface sample_leaf(std::size_t i, double folding_angle) {
    Plant sample = sample_plant();
    sample.blade.folding_angle = folding_angle;
    return LeafSurface(sample.leaves[i], sample.blade);
}

class EveryLeaf : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Sample, EveryLeaf, ::testing::Values(0u, 1u, 2u));

TEST_P(EveryLeaf, TessellationHasTheLengthAndWidthOfTheLeaf) {
    const Plant sample = sample_plant();
    for (const int cells : {4, 12, 40}) {
        const auto rows = sample_leaf(GetParam(), 10).tessellate(cells);
        double length = 0, width = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i > 0) length += distance(rows[i].midrib, rows[i - 1].midrib);
            width = std::max(width, blade_width(rows[i]));
        }
        EXPECT_NEAR(length / sample.leaves[GetParam()].length, 1, 1e-12);
        EXPECT_NEAR(width / sample.leaves[GetParam()].width, 1, 1e-12);
    }
}

TEST_P(EveryLeaf, SurfaceHasNearlyTheLengthAndWidthOfTheLeaf) {
    const Plant sample = sample_plant();
    const LeafSurface leaf = sample_leaf(GetParam(), 10);
    double length = 0, width = 0;
    for (int i = 1; i <= 1000; ++i) {
        length += distance(leaf.row(i / 1000.).midrib,
                           leaf.row((i - 1) / 1000.).midrib);
        width = std::max(width, blade_width(leaf.row(i / 1000.)));
    }
    EXPECT_NEAR(length / sample.leaves[GetParam()].length, 1, 1e-3);
    EXPECT_NEAR(width / sample.leaves[GetParam()].width, 1, 2e-3);
}

TEST_P(EveryLeaf, MidribFollowsTheAnglesOfTheLeaf) {
    const Plant sample = sample_plant();
    const Leaf& traits = sample.leaves[GetParam()];
    const LeafSurface leaf = sample_leaf(GetParam(), 0);
    double arc = 0;
    for (int i = 1; i <= 2000; ++i) {
        const glm::dvec3 a = leaf.row((i - 1) / 2000.).midrib;
        const glm::dvec3 b = leaf.row(i / 2000.).midrib;
        arc += distance(a, b);
        const double s = arc / traits.length;
        const double expected =
            traits.insertion_angle + traits.curvature * std::pow(s, 1.5);
        const double angle =
            std::atan2(b.y - a.y, b.z - a.z) * 180 / std::acos(-1.);
        EXPECT_NEAR(angle, expected, 2.5) << "at s = " << s;
    }
}

TEST(LeafSurface, WidthProfileMatchesPublishedMaize) {
    // Relative widths of a maize blade at tenths of its length, and its area
    // factor. The six-point spline reproduces the area exactly and the widths
    // to within 0.023.
    const double published[] = {.28, .70, .88, .935, .97, .98,
                                .96, .88, .66, .35,  0};
    const LeafSurface leaf({1, 0.1, 45, 0, 0, 0.5}, sample_plant().blade);
    double area = 0;
    for (int i = 0; i <= 10; ++i)
        EXPECT_NEAR(blade_width(leaf.row(i / 10.)) / 0.1, published[i], 0.024);
    for (int i = 0; i < 1000; ++i)
        area += blade_width(leaf.row((i + .5) / 1000.)) / 1000.;
    EXPECT_NEAR(area / 0.1, 0.7455, 1e-5);
}

TEST(LeafSurface, FoldingRaisesTheEdgesTowardsTheUpperSide) {
    const BladeRow flat = sample_leaf(2, 0).row(0.3);
    const BladeRow folded = sample_leaf(2, 20).row(0.3);
    EXPECT_NEAR(flat.left.z, flat.midrib.z, 1e-12);
    EXPECT_GT(folded.left.z, folded.midrib.z);
    EXPECT_NEAR(blade_width(folded), blade_width(flat), 1e-9);
}

//! Makes a leaf with a rolled and twisted blade.
Leaf rolled_leaf() {
    Leaf leaf = sample_plant().leaves[1];
    leaf.roll = 40;
    leaf.twist = 120;
    return leaf;
}

TEST(LeafSurface, RollAndTwistTurnTheBladeAboutItsMidrib) {
    Blade flat = sample_plant().blade;
    flat.folding_angle = 0;
    const Leaf rolled = rolled_leaf();
    const LeafSurface level(sample_plant().leaves[1], flat);
    const LeafSurface surface(rolled, flat);
    for (const double t : {0.1, 0.5, 0.9}) {
        const BladeRow a = level.row(t), b = surface.row(t);
        EXPECT_EQ(a.midrib, b.midrib);
        const double cosine = glm::dot(glm::normalize(a.right - a.midrib),
                                       glm::normalize(b.right - b.midrib));
        EXPECT_NEAR(cosine,
                    std::cos((40 + 120 * (t - .5)) / 180 * std::numbers::pi),
                    1e-9);
        EXPECT_NEAR(blade_width(a), blade_width(b), 1e-12);
    }
    // A positive roll lowers the right edge.
    EXPECT_LT(surface.row(0.5).right.z, surface.row(0.5).midrib.z);
}

TEST(LeafSurface, RolledBladesKeepLengthWidthAndArea) {
    const Leaf rolled = rolled_leaf();
    Leaf plain = rolled;
    plain.roll = plain.twist = 0;
    const Blade blade = sample_plant().blade;
    const auto area = [&](const Leaf& leaf) {
        Plant plant = sample_plant();
        plant.leaves = {leaf};
        plant.stalk.is_present = false;
        plant.organs.clear();
        return plant_area(build_plant(plant, {40, 8})).leaves;
    };
    double length = 0, width = 0;
    const auto rows = LeafSurface(rolled, blade).tessellate(12);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i > 0) length += distance(rows[i].midrib, rows[i - 1].midrib);
        width = std::max(width, blade_width(rows[i]));
    }
    EXPECT_NEAR(length / rolled.length, 1, 2e-4);
    EXPECT_NEAR(width / rolled.width, 1, 2e-4);
    EXPECT_NEAR(area(rolled) / area(plain), 1, 0.01);
}

TEST(LeafSurface, DigitisedMidribsAreFollowed) {
    // The midrib is an arc of 140 deg with a kink, which no power of arc length
    // can represent.
    Leaf leaf{0.8, 0.1, 0, 0, 0, 0.5};
    glm::dvec2 end{3, 7};
    leaf.midrib = {end};
    for (int i = 0; i < 20; ++i) {
        const double angle = (i < 12 ? 20 + 2. * i : 90 + 8. * (i - 12)) *
                             std::numbers::pi / 180;
        end += 4. * glm::dvec2(std::sin(angle), std::cos(angle));
        leaf.midrib.push_back(end);
    }
    measure_midrib(leaf);
    EXPECT_NEAR(leaf.insertion_angle, 20, 1e-9);
    EXPECT_NEAR(leaf.curvature, 90 + 56 - 20, 1e-9);
    const LeafSurface surface(leaf, sample_plant().blade, 0.01);
    double squares = 0;
    for (std::size_t i = 0; i <= 20; ++i) {
        const glm::dvec2 wanted =
            (leaf.midrib[i] - leaf.midrib[0]) / 100. + glm::dvec2(0.01, 0.5);
        const glm::dvec3 met = surface.row(static_cast<double>(i) / 20).midrib;
        squares +=
            std::pow(met.y - wanted.x, 2) + std::pow(met.z - wanted.y, 2);
    }
    EXPECT_LT(std::sqrt(squares / 21), 0.002);
    // Adding 10 deg to the insertion angle rotates the whole midrib.
    leaf.insertion_angle += 10;
    const LeafSurface turned(leaf, sample_plant().blade, 0.01);
    const auto direction = [](const LeafSurface& leaf_surface) {
        const glm::dvec3 chord =
            leaf_surface.row(1).midrib - leaf_surface.row(0).midrib;
        return std::atan2(chord.y, chord.z) * 180 / std::numbers::pi;
    };
    EXPECT_NEAR(direction(turned) - direction(surface), 10, 1e-6);
}

TEST(LeafSurface, MidribsOfOnePointAreRefused) {
    Leaf leaf{0.8, 0.1, 0, 0, 0, 0.5};
    leaf.midrib = {{1, 1}, {1, 1}};
    EXPECT_THROW(LeafSurface(leaf, sample_plant().blade), Error);
}

TEST(LeafSurface, WrongNumberOfWidthControlsIsRefused) {
    EXPECT_THROW(LeafSurface({1, 0.1, 45, 0, 0, 0.5}, {{1, 1}, 0, 1.5}), Error);
}

}  // namespace
}  // namespace ideotype
