// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "search/sensitivity_design.hpp"

namespace ideotype {
namespace {

//! A search space of three angles, and a fourth gene without effect.
SearchSpace angles() {
    const double pi = std::numbers::pi;
    SearchSpace space;
    for (const char* name : {"a", "b", "c", "none"}) {
        space.genes.push_back({name, "1", -pi, pi, false, true, name});
        space.baseline.push_back(0);
    }
    return space;
}

TEST(Sensitivity, GroupsChangeTogetherAndFixedGenesStay) {
    SearchSpace space = angles();
    space.genes[0].trait = space.genes[2].trait = "both";
    space.genes[1].is_free = false;
    space.baseline[1] = 0.5;
    for (const auto method :
         {SensitivityMethod::sobol, SensitivityMethod::morris}) {
        const SensitivityDesign design({.method = method, .samples = 64}, space,
                                       1);
        ASSERT_EQ(design.factors().size(), 2U);
        EXPECT_EQ(design.factors()[0].name, "both");
        EXPECT_EQ(design.factors()[0].genes, (std::vector<std::size_t>{0, 2}));
        for (std::uint32_t i = 0; i < design.samples(); ++i)
            for (std::size_t k = 0; k < 2; ++k) {
                const Genome a = design.make_row(i, k),
                             b = design.make_row(i, k + 1);
                EXPECT_EQ(b[1], 0.5);
                EXPECT_EQ(a[0] == b[0], a[2] == b[2]);
                const bool is_one = (a[0] == b[0]) != (a[3] == b[3]);
                EXPECT_TRUE(is_one || method == SensitivityMethod::sobol);
            }
    }
}

TEST(Sensitivity, PathsStepOnAGridAndTwoEndsOfACircleAreOneLevel) {
    SearchSpace space = angles();
    space.genes[1].is_circular = true;
    const SensitivityDesign design(
        {.method = SensitivityMethod::morris, .samples = 200}, space, 1);
    std::set<double> plain, circular;
    for (std::uint32_t i = 0; i < design.samples(); ++i)
        for (std::size_t k = 0; k < design.rows_per_sample(); ++k) {
            const Genome x = design.make_row(i, k);
            plain.insert(std::round(1e9 * x[0]));
            circular.insert(std::round(1e9 * x[1]));
        }
    EXPECT_EQ(plain.size(), 4U);
    EXPECT_EQ(circular.size(), 4U);
    EXPECT_NEAR(*plain.rbegin(), 1e9 * std::numbers::pi, 2);
    EXPECT_NEAR(*circular.rbegin(), 1e9 * std::numbers::pi / 2, 2);
}

TEST(Sensitivity, RowsAreProposedInOrder) {
    const SensitivitySettings settings{.samples = 20};
    SensitivityDesign design(settings, angles(), 3);
    std::size_t rows = 0;
    for (std::uint32_t g = 0; g < 2; ++g) {
        EXPECT_LE(static_cast<int>(design.size(g)),
                  generation_size(settings, angles().genes));
        for (std::uint32_t slot = 0; slot < design.size(g); ++slot, ++rows) {
            EXPECT_EQ(design.needs(g), 0U);
            EXPECT_EQ(design.propose(g, slot).genome,
                      design.make_row(static_cast<std::uint32_t>(rows / 6),
                                      rows % 6));
        }
    }
    EXPECT_EQ(count_generations(settings), 2);
    EXPECT_EQ(rows, 120U);
    EXPECT_TRUE(design.best(5).empty());
}

}  // namespace
}  // namespace ideotype
