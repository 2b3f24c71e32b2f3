// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "search/unbounded_genes.hpp"

namespace ideotype {
namespace {

const GeneSpace genes{{"length", "m", 0.4, 1.2, false, true},
                      {"azimuth", "deg", 0, 360, true, true},
                      {"width", "m", 0.05, 0.14, false, false},
                      {"fixed", "m", 1, 1, false, true}};
const Genome baseline{0.7, 90, 0.08, 1};

TEST(UnboundedGenes, CoordinatesAreFreeGenesWithARange) {
    EXPECT_EQ(UnboundedGenes(genes).to_coordinates(baseline).size(), 2U);
}

TEST(UnboundedGenes, ConversionIsReversible) {
    const UnboundedGenes unbounded(genes);
    for (const double length : {0.4, 0.401, 0.43, 0.8, 1.19, 1.2})
        for (const double azimuth : {0.0, 1e-9, 180.0, 359.9}) {
            const Genome genome{length, azimuth, 0.08, 1};
            const Genome again =
                unbounded.to_genome(unbounded.to_coordinates(genome), baseline);
            EXPECT_NEAR(again[0], length, 1e-14);
            EXPECT_NEAR(again[1], azimuth, 1e-12);
            EXPECT_EQ(again[2], baseline[2]);
            EXPECT_EQ(again[3], baseline[3]);
        }
}

TEST(UnboundedGenes, GenesStayWithinBoundsWithoutJumps) {
    const UnboundedGenes unbounded(genes);
    constexpr double step = 1e-3;
    double before = unbounded.to_genome({-5, 0}, baseline)[0], slope = 0;
    for (double x = -5 + step; x < 5; x += step) {
        const double length = unbounded.to_genome({x, 0}, baseline)[0];
        EXPECT_GE(length, 0.4);
        EXPECT_LE(length, 1.2);
        const double next = (length - before) / step;
        if (x > -5 + 2 * step) {
            EXPECT_NEAR(next, slope, 0.8 * step / 0.1 * 1.01);
        }
        before = length;
        slope = next;
    }
}

TEST(UnboundedGenes, GeneIsAtABoundWithinATwentiethOfItsRange) {
    const Gene& length = genes[0];  // 0.4 to 1.2
    EXPECT_EQ(find_bound(length, 0.4), Bound::lower);
    EXPECT_EQ(find_bound(length, 0.439), Bound::lower);
    EXPECT_EQ(find_bound(length, 0.441), std::nullopt);
    EXPECT_EQ(find_bound(length, 1.159), std::nullopt);
    EXPECT_EQ(find_bound(length, 1.161), Bound::upper);
    // The genes are circular, fixed, and without a range.
    for (const std::size_t i : {1U, 2U, 3U})
        EXPECT_EQ(find_bound(genes[i], genes[i].lower), std::nullopt);
}

TEST(UnboundedGenes, WholeTurnsDoNotChangeCircularGenes) {
    const UnboundedGenes unbounded(genes);
    for (const double turns : {-3.0, -1.0, 0.0, 2.0}) {
        EXPECT_NEAR(unbounded.to_genome({0.5, turns + 0.25}, baseline)[1], 90,
                    1e-9);
    }
    EXPECT_LT(unbounded.to_genome({0.5, -1e-18}, baseline)[1], 360);
}

}  // namespace
}  // namespace ideotype
