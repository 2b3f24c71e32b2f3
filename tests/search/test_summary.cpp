#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/search/summary.hpp"

namespace ideotype {
namespace {

Individual individual(Genome genome, double fitness,
                      Status status = Status::done) {
    return {{std::move(genome), Origin::child, {0, 0}}, status, fitness, 0.1};
}

TEST(Summary, DescribesWhatDidNotFail) {
    const GeneSpace genes{{"length", "m", 0, 10, false, true},
                          {"azimuth", "deg", 0, 360, true, true},
                          {"width", "m", 0, 1, false, false}};
    const Population population{individual({2, 359, 0}, 10),
                                individual({4, 1, 0}, 20),
                                individual({9, 90, 0}, 99, Status::failed)};
    const GenerationSummary s = summarize(population, genes);
    EXPECT_EQ(s.best_slot, 1u);
    EXPECT_DOUBLE_EQ(s.best, 20);
    EXPECT_DOUBLE_EQ(s.mean, 15);
    EXPECT_DOUBLE_EQ(s.spread, 5);
    EXPECT_EQ(s.failures, 1u);
    EXPECT_EQ(s.evaluations, 3u);
    // 1 of 10 along the length, 1 of 360 around north.
    EXPECT_NEAR(s.diversity, (0.1 + 1 / 360.) / 2, 1e-12);
}

TEST(Summary, TheMeanIsOfPlantsThatKeepToTheirConstraints) {
    const Population mixed{individual({1}, -3), individual({2}, 4),
                           individual({3}, 6)};
    EXPECT_DOUBLE_EQ(summarize(mixed, {}).mean, 5);
    const Population none{individual({1}, -3), individual({2}, -1)};
    EXPECT_DOUBLE_EQ(summarize(none, {}).mean, -2);
}

TEST(Summary, CountsDuplicatesOnce) {
    const Population population{individual({1}, 5), individual({2}, 7),
                                individual({1}, 5)};
    EXPECT_EQ(summarize(population, {}).evaluations, 2u);
}

TEST(Summary, OfNothingButFailuresIsNotANumber) {
    const GenerationSummary s =
        summarize({individual({1}, 1, Status::failed)}, {});
    EXPECT_TRUE(std::isnan(s.best));
    EXPECT_EQ(s.failures, 1u);
}

}  // namespace
}  // namespace ideotype
