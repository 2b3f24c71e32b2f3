#include <gtest/gtest.h>

#include "ideotype/search/stop_rules.hpp"

namespace ideotype {
namespace {

StopRules only_generations() {
    StopRules rules;
    rules.generations = 5;
    return rules;
}

TEST(StopRules, GenerationsEndTheEvolution) {
    const StopRules rules = only_generations();
    EXPECT_EQ(finished(rules, {{1, 1, 1, 1}, {1, 1, 1, 1}}), std::nullopt);
    EXPECT_EQ(finished(rules, {{1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}}),
              "generations");
}

TEST(StopRules, TargetLooksAtTheLatestBest) {
    StopRules rules = only_generations();
    rules.target = 9;
    EXPECT_EQ(finished(rules, {{1}, {8.9}}), std::nullopt);
    EXPECT_EQ(finished(rules, {{1}, {9}}), "target");
}

TEST(StopRules, EvaluationsAndWallTimeAreTotals) {
    StopRules rules = only_generations();
    rules.evaluations = 100;
    rules.wall_time = 60;
    EXPECT_EQ(finished(rules, {{1}, {1}, 99, 59}), std::nullopt);
    EXPECT_EQ(finished(rules, {{1}, {1}, 100, 59}), "evaluations");
    EXPECT_EQ(finished(rules, {{1}, {1}, 99, 60}), "wall_time");
}

TEST(StopRules, StagnationNeedsThatManyGenerationsWithoutABetterMean) {
    StopRules rules;
    rules.generations = 100;
    rules.stagnation = 3;
    EXPECT_EQ(finished(rules, {{1, 2, 2, 2}, {1, 2, 2, 2}}), std::nullopt);
    EXPECT_EQ(finished(rules, {{1, 3, 2, 2, 2}, {1, 3, 2, 2, 2}}),
              "stagnation");
    EXPECT_EQ(finished(rules, {{1, 3, 2, 2, 4}, {1, 3, 2, 2, 4}}),
              std::nullopt);
}

}  // namespace
}  // namespace ideotype
