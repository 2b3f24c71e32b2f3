// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "individual.hpp"
#include "search/order.hpp"

namespace ideotype {
namespace {

class Order : public ::testing::TestWithParam<Sense> {};

//! Makes individuals, worst first: a failure, constraint violations with any
//! objective, then objectives of both signs.
Population make_worst_first(Sense sense) {
    const double sign = sense == Sense::maximise ? 1 : -1;
    return {make_failed_individual({0}, sign * 99),
            make_individual({1}, sign * 50, 3),
            make_individual({2}, sign * -50, 0.5),
            make_individual({3}, sign * -7),
            make_individual({4}, 0),
            make_individual({5}, sign * 2)};
}

TEST_P(Order, FailuresThenViolationsThenTheObjectiveDecide) {
    const Population population = make_worst_first(GetParam());
    for (std::size_t a = 0; a < population.size(); ++a)
        for (std::size_t b = 0; b < population.size(); ++b)
            EXPECT_EQ(is_better(population[a], population[b], GetParam()),
                      a > b)
                << a << " " << b;
}

TEST_P(Order, EqualViolationsAreEquallyGood) {
    const Individual a = make_individual({1}, 5, 0.25),
                     b = make_individual({2}, 9, 0.25);
    EXPECT_FALSE(is_better(a, b, GetParam()));
    EXPECT_FALSE(is_better(b, a, GetParam()));
}

TEST_P(Order, BestIndividualsComeFirstWithoutFailures) {
    EXPECT_EQ(best_distinct(make_worst_first(GetParam()), 4, {GetParam()}),
              (std::vector<std::uint32_t>{5, 4, 3, 2}));
    EXPECT_EQ(
        best_distinct(make_worst_first(GetParam()), 9, {GetParam()}).size(),
        5u);
}

INSTANTIATE_TEST_SUITE_P(BothSenses, Order,
                         ::testing::Values(Sense::maximise, Sense::minimise));

TEST(BestDistinct, DuplicatesAreSkippedAndEqualsKeepTheirOrder) {
    const Population population{
        make_individual({1}, 5), make_individual({2}, 7),
        make_individual({2}, 7), make_individual({3}, 7),
        make_individual({4}, 6)};
    EXPECT_EQ(best_distinct(population, 3, {Sense::maximise}),
              (std::vector<std::uint32_t>{1, 3, 4}));
}

}  // namespace
}  // namespace ideotype
