// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "tolerance/allocation.hpp"

namespace ideotype {
namespace {

double variance_of(const ByOrigin<Law>& laws, const Amounts& amounts) {
    double sum = 0;
    for (std::size_t o = 0; o < origins; ++o)
        if (laws[o].variance > 0) sum += laws[o].at(amounts[o]);
    return sum;
}

double cost_of(const ByOrigin<double>& costs, const Amounts& amounts) {
    double sum = 0;
    for (std::size_t o = 0; o < origins; ++o) sum += costs[o] * amounts[o];
    return sum;
}

TEST(Allocation, IsNeymansForIndependentDraws) {
    const Amounts amounts =
        allocate({{{1, 9, 1}, {10, .4, 1}, {1, 1, 1}}}, {1, 4, 1}, .5);
    // Amounts are proportional to the standard deviation divided by the root of
    // the cost.
    EXPECT_NEAR(amounts[1] / amounts[0], (2. / 2) / 3, 1e-9);
    EXPECT_NEAR(amounts[2] / amounts[0], 1. / 3, 1e-9);
    EXPECT_NEAR(9 / amounts[0] + 4 / amounts[1] + 1 / amounts[2], .5, 1e-9);
}

TEST(Allocation, IsCheapestForAnyPowers) {
    const ByOrigin<Law> laws{{{100, 3e-4, 1.4}, {20, 1e-3, 1}, {7, 2e-3, 1}}};
    const ByOrigin<double> costs{.02, .5, 1.2};
    const Amounts best = allocate(laws, costs, 1e-4);
    EXPECT_NEAR(variance_of(laws, best) / 1e-4, 1, 1e-9);
    for (std::size_t o = 0; o < origins; ++o)
        for (const double change : {.97, 1.03}) {
            Amounts other = best;
            other[o] *= change;
            // The other amounts are scaled so that the variance is unchanged.
            double lower = .5, upper = 2;
            for (int i = 0; i < 60; ++i) {
                const double middle = (lower + upper) / 2;
                Amounts scaled_others = other;
                for (std::size_t p = 0; p < origins; ++p)
                    if (p != o) scaled_others[p] *= middle;
                (variance_of(laws, scaled_others) > 1e-4 ? lower : upper) =
                    middle;
            }
            for (std::size_t p = 0; p < origins; ++p)
                if (p != o) other[p] *= upper;
            EXPECT_GT(cost_of(costs, other), cost_of(costs, best));
        }
}

TEST(Allocation, GivesNothingToOriginsWithoutVariance) {
    const Amounts amounts =
        allocate({{{10, 1e-3, 1}, {10, 0, 1}, {10, 0, 1}}}, {1, 1, 0}, 1e-5);
    EXPECT_NEAR(amounts[0], 1000, 1e-6);
    EXPECT_EQ(amounts[1], 0);
    EXPECT_EQ(amounts[2], 0);
}

}  // namespace
}  // namespace ideotype
