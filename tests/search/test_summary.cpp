// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "individual.hpp"
#include "search/summary.hpp"

namespace ideotype {
namespace {

TEST(Summary, StatisticsExcludeFailures) {
    const GeneSpace genes{{"length", "m", 0, 10, false, true},
                          {"azimuth", "deg", 0, 360, true, true},
                          {"width", "m", 0, 1, false, false}};
    const Population population{make_individual({2, 359, 0}, 10),
                                make_individual({4, 1, 0}, 20),
                                make_failed_individual({9, 90, 0}, 99)};
    const GenerationSummary s = summarize(population, genes, Sense::maximise);
    EXPECT_EQ(s.best_slot, 1u);
    EXPECT_DOUBLE_EQ(s.best, 20);
    EXPECT_DOUBLE_EQ(s.mean, 15);
    EXPECT_DOUBLE_EQ(s.spread, 5);
    EXPECT_EQ(s.failures, 1u);
    EXPECT_EQ(s.evaluations, 3u);
    // The standard deviations are 1 of a range of 10 for the length, and 1 of
    // 360 for the azimuth near north.
    EXPECT_NEAR(s.diversity, (0.1 + 1 / 360.) / 2, 1e-12);
}

TEST(Summary, StatisticsAreOfFeasiblePlantsIfAny) {
    const Population mixed{make_individual({1}, 30, 3),
                           make_individual({2}, -4), make_individual({3}, -6)};
    const GenerationSummary s = summarize(mixed, {}, Sense::maximise);
    EXPECT_EQ(s.best_slot, 1u);
    EXPECT_DOUBLE_EQ(s.best, -4);
    EXPECT_DOUBLE_EQ(s.mean, -5);
    EXPECT_DOUBLE_EQ(s.spread, 1);
    EXPECT_EQ(s.violation, 0);
}

TEST(Summary, StatisticsAreOfInfeasiblePlantsIfNoneIsFeasible) {
    const Population none{make_individual({1}, 30, 3),
                          make_individual({2}, 10, 1),
                          make_failed_individual({3}, 99)};
    const GenerationSummary s = summarize(none, {}, Sense::maximise);
    EXPECT_EQ(s.best_slot, 1u);
    EXPECT_DOUBLE_EQ(s.best, 10);
    EXPECT_DOUBLE_EQ(s.best_standard_error, 0.1);
    EXPECT_DOUBLE_EQ(s.mean, 20);
    EXPECT_DOUBLE_EQ(s.spread, 10);
    EXPECT_EQ(s.violation, 1);
}

TEST(Summary, BestIsTheSmallestOfAMinimisedObjective) {
    const Population population{make_individual({1}, 5),
                                make_individual({2}, -7)};
    const auto s = summarize(population, {}, Sense::minimise);
    EXPECT_EQ(s.best_slot, 1u);
    EXPECT_DOUBLE_EQ(s.best, -7);
    EXPECT_DOUBLE_EQ(s.mean, -1);
}

TEST(Summary, DuplicatesCountAsOneEvaluation) {
    const Population population{make_individual({1}, 5),
                                make_individual({2}, 7),
                                make_individual({1}, 5)};
    EXPECT_EQ(summarize(population, {}, Sense::maximise).evaluations, 2u);
}

TEST(Summary, StatisticsAreNaNIfAllFailed) {
    const GenerationSummary s =
        summarize({make_failed_individual({1}, 1)}, {}, Sense::maximise);
    EXPECT_TRUE(std::isnan(s.best));
    EXPECT_EQ(s.failures, 1u);
}

}  // namespace
}  // namespace ideotype
