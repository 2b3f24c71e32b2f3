// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "run/bounds.hpp"

namespace ideotype {
namespace {

GeneSpace gene_space() {
    GeneSpace genes{{"height", "1", 0.7, 1.3, false, true, "height", 0},
                    {"azimuth", "deg", 0, 360, true, true, "azimuth", 0},
                    {"roll", "deg", 0, 90, false, false, "roll", 0}};
    for (int point = 1; point <= 5; ++point)
        genes.push_back({"width_profile_" + std::to_string(point), "1", 0.65,
                         1.35, false, true, "width_profile", 0});
    return genes;
}

//! Returns a plant from its height and the widths at its two highest points.
Genome plant(double height, double fourth, double fifth) {
    return {height, 0, 0, 1, 1, 1, fourth, fifth};
}

BoundCount count_of(const std::vector<Genome>& plants) {
    BoundCount count;
    for (const Genome& each : plants) count.add(gene_space(), each);
    return count;
}

TEST(Bounds, AreNamedByGene) {
    const auto at_bounds =
        genes_at_bounds(gene_space(), plant(0.701, 1, 1.349));
    ASSERT_EQ(at_bounds.size(), 2U);
    EXPECT_EQ(at_bounds[0].gene, "height");
    EXPECT_EQ(at_bounds[0].bound, Bound::lower);
    EXPECT_EQ(at_bounds[0].value, 0.701);
    EXPECT_EQ(at_bounds[0].limit, 0.7);
    EXPECT_EQ(at_bounds[1].gene, "width_profile_5");
    EXPECT_EQ(at_bounds[1].bound, Bound::upper);
    EXPECT_EQ(at_bounds[1].limit, 1.35);
}

TEST(Bounds, AreCountedOverSearches) {
    // The heights are those found by three searches of
    // campaigns/quickstart.toml.
    EXPECT_EQ(
        count_of({plant(0.701, 1, 1), plant(0.713, 1, 1), plant(0.726, 1, 1)})
            .in_words(),
        "height is at its lower bound in 3 of 3 searches; the gain may "
        "be limited by the bound");
    EXPECT_EQ(count_of({plant(1.3, 0.65, 0.66)}).in_words(),
              "height is at its upper bound, width profile is at its lower "
              "bound in 2 of 5 values; the gain may be limited by these "
              "bounds");
    EXPECT_EQ(count_of({plant(0.74, 1, 1), plant(1, 1, 1)}).in_words(), "");
}

TEST(Bounds, AreNotReportedForFewValues) {
    // One value in five reaches the threshold of a fifth, one in ten does not.
    EXPECT_NE(count_of({plant(1, 1, 1.35)}).in_words(), "");
    EXPECT_EQ(count_of({plant(1, 1, 1.35), plant(1, 1, 1)}).in_words(), "");
}

TEST(Bounds, CountsOfSeveralMastersAreAdded) {
    BoundCount together;
    for (const double height : {0.7, 1.0, 1.3})
        together.add(bound_count_of(to_text(count_of({plant(height, 1, 1)}))));
    EXPECT_EQ(together.in_words(),
              count_of({plant(0.7, 1, 1), plant(1, 1, 1), plant(1.3, 1, 1)})
                  .in_words());
    EXPECT_EQ(together.searches, 3);
    EXPECT_EQ(BoundCount{}.in_words(), "");
}

}  // namespace
}  // namespace ideotype
