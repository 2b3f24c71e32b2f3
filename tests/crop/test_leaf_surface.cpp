// SPDX-License-Identifier: Apache-2.0
#include <cmath>

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

TEST_P(EveryLeaf, LengthAndWidthAreMetByTheTessellation) {
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

TEST_P(EveryLeaf, SurfaceItselfNeedsHardlyAnyStretching) {
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

TEST_P(EveryLeaf, MidribFollowsItsAngles) {
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

TEST(LeafSurface, WidthProfileIsThatOfMaize) {
    // Relative widths at tenths of the length and the area factor of a maize
    // blade; the six-point spline trades 0.023 of width for exact area.
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

TEST(LeafSurface, FoldRaisesTheEdgesTowardsTheUpperSide) {
    const BladeRow flat = sample_leaf(2, 0).row(0.3);
    const BladeRow folded = sample_leaf(2, 20).row(0.3);
    EXPECT_NEAR(flat.left.z, flat.midrib.z, 1e-12);
    EXPECT_GT(folded.left.z, folded.midrib.z);
    EXPECT_NEAR(blade_width(folded), blade_width(flat), 1e-9);
}

TEST(LeafSurface, RefusesAWrongNumberOfWidthControls) {
    EXPECT_THROW(LeafSurface({1, 0.1, 45, 0, 0, 0.5}, {{1, 1}, 0, 1.5}), Error);
}

}  // namespace
}  // namespace ideotype
