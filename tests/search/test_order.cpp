#include <gtest/gtest.h>

#include "ideotype/search/order.hpp"

namespace ideotype {
namespace {

Individual individual(Genome genome, double fitness,
                      Status status = Status::done) {
    return {{std::move(genome), Origin::child, {0, 0}}, status, fitness, 0.1};
}

TEST(Order, AFailureIsWorseThanAnything) {
    const Individual failed = individual({0}, 99, Status::failed);
    const Individual poor = individual({0}, -1e9);
    EXPECT_TRUE(is_better(poor, failed));
    EXPECT_FALSE(is_better(failed, poor));
    EXPECT_FALSE(is_better(failed, failed));
}

TEST(Order, BestDistinctSkipsDuplicatesAndFailures) {
    const Population population{
        individual({1}, 5), individual({2}, 7), individual({2}, 7),
        individual({3}, 9, Status::failed), individual({4}, 6)};
    EXPECT_EQ(best_distinct(population, 3),
              (std::vector<std::uint32_t>{1, 4, 0}));
    EXPECT_EQ(best_distinct(population, 9).size(), 3u);
}

}  // namespace
}  // namespace ideotype
