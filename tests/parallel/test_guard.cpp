// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "fake_evaluator.hpp"
#include "ideotype/core/host.hpp"
#include "workers.hpp"

namespace ideotype {

namespace {

Outcome evaluate_slot(std::uint32_t slot,
                      std::chrono::milliseconds duration = {}) {
    FakeEvaluator evaluator(duration);
    Work work;
    work.task.slot = slot;
    work.genome = {1, 2, 3};
    return evaluate_guarded(evaluator, work, 7, machine_clock);
}

void expect_failed_everywhere(const Outcome& outcome) {
    EXPECT_EQ(outcome.status, Status::failed);
    ASSERT_EQ(outcome.objectives.size(), 2u);
    ASSERT_EQ(outcome.quantities.size(), 3u);
    for (const auto& columns : {outcome.objectives, outcome.quantities})
        for (const Estimate& x : columns) {
            EXPECT_TRUE(std::isnan(x.mean));
            EXPECT_TRUE(std::isnan(x.standard_error));
        }
}

}  // namespace

TEST(EvaluateGuarded, ResultIsPassedOn) {
    const Outcome outcome = evaluate_slot(5);
    EXPECT_EQ(outcome.status, Status::done);
    EXPECT_EQ(outcome.message, "");
    EXPECT_EQ(outcome.worker, 7u);
    EXPECT_EQ(
        outcome.objectives.at(0).mean,
        FakeEvaluator().evaluate({0, 0, 5}, {1, 2, 3}).objectives.at(0).mean);
}

TEST(EvaluateGuarded, WallTimeIsMeasured) {
    const Outcome outcome = evaluate_slot(5, std::chrono::milliseconds(20));
    EXPECT_GE(outcome.seconds, 0.02);
    EXPECT_LT(outcome.seconds, 10);
}

TEST(EvaluateGuarded, ErrorBecomesAFailureWithItsMessage) {
    const Outcome outcome = evaluate_slot(FakeEvaluator::throwing_slot);
    expect_failed_everywhere(outcome);
    EXPECT_EQ(outcome.message, "leaf 3 is longer than the row");
    EXPECT_EQ(outcome.worker, 7u);
}

TEST(EvaluateGuarded, FailureOfTheMachineLeavesTheRowProposed) {
    for (const auto& [slot, reason] :
         {std::pair{FakeEvaluator::starved_slot, "not enough memory"},
          std::pair{FakeEvaluator::oddly_throwing_slot,
                    "an exception of unknown type"}}) {
        const Outcome outcome = evaluate_slot(slot);
        EXPECT_EQ(outcome.status, Status::proposed);
        EXPECT_EQ(outcome.message, "on " + host_name() + ": " + reason);
        EXPECT_TRUE(outcome.quantities.empty());
        EXPECT_EQ(outcome.worker, 7u);
    }
}

TEST(EvaluateGuarded, NonFiniteColumnIsNamed) {
    const Outcome outcome = evaluate_slot(FakeEvaluator::not_a_number_slot);
    expect_failed_everywhere(outcome);
    EXPECT_NE(outcome.message.find("height is not finite"), std::string::npos)
        << outcome.message;
}

}  // namespace ideotype
