// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "individual.hpp"
#include "search/order.hpp"

namespace ideotype {
namespace {

class Order : public ::testing::TestWithParam<Sense> {};

//! Individuals, worst first: a failure, violations with any objective, and
//! objectives of both signs.
Population worst_first(Sense sense) {
    const double sign = sense == Sense::maximise ? 1 : -1;
    return {failed_individual({0}, sign * 99),
            individual({1}, sign * 50, 3),
            individual({2}, sign * -50, 0.5),
            individual({3}, sign * -7),
            individual({4}, 0),
            individual({5}, sign * 2)};
}

TEST_P(Order, FailuresThenViolationsThenTheObjective) {
    const Population all = worst_first(GetParam());
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < all.size(); ++b)
            EXPECT_EQ(is_better(all[a], all[b], GetParam()), a > b)
                << a << " " << b;
}

TEST_P(Order, EqualViolationsAreEquallyGood) {
    const Individual a = individual({1}, 5, 0.25), b = individual({2}, 9, 0.25);
    EXPECT_FALSE(is_better(a, b, GetParam()));
    EXPECT_FALSE(is_better(b, a, GetParam()));
}

TEST_P(Order, BestDistinctIsBestFirstWithoutFailures) {
    EXPECT_EQ(best_distinct(worst_first(GetParam()), 4, {GetParam()}),
              (std::vector<std::uint32_t>{5, 4, 3, 2}));
    EXPECT_EQ(best_distinct(worst_first(GetParam()), 9, {GetParam()}).size(),
              5u);
}

INSTANTIATE_TEST_SUITE_P(BothSenses, Order,
                         ::testing::Values(Sense::maximise, Sense::minimise));

TEST(BestDistinct, SkipsDuplicatesAndKeepsTheOrderOfEquals) {
    const Population population{individual({1}, 5), individual({2}, 7),
                                individual({2}, 7), individual({3}, 7),
                                individual({4}, 6)};
    EXPECT_EQ(best_distinct(population, 3, {Sense::maximise}),
              (std::vector<std::uint32_t>{1, 3, 4}));
}

}  // namespace
}  // namespace ideotype
