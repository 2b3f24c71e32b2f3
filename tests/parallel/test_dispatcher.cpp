// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <set>

#include "fake_workers.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"

namespace ideotype {

class DispatcherOfFakes : public WithAnyWorkers, public Kept {};

INSTANTIATE_TEST_SUITE_P(Workers, DispatcherOfFakes, testing::Values(1, 2, 8));

TEST_P(DispatcherOfFakes, EveryTaskIsRecordedOnce) {
    Dispatcher dispatcher = make(GetParam());
    EXPECT_EQ(dispatcher.width(), GetParam());
    const std::vector<Work> work = sample_work(50);
    evaluate(dispatcher, work, keep());
    expect_all(work);
    EXPECT_NEAR(clock_.now(), 100 + 0.01 * ((49 + GetParam()) / GetParam()),
                1e-9);
    EXPECT_TRUE(dispatcher.dismiss());
}

TEST_P(DispatcherOfFakes, LessWorkThanWorkersIsEvaluated) {
    Dispatcher dispatcher = make(GetParam());
    evaluate(dispatcher, {}, keep());
    EXPECT_TRUE(outcomes.empty());
    evaluate(dispatcher, sample_work(1), keep());
    EXPECT_EQ(outcomes.size(), 1u);
}

TEST_P(DispatcherOfFakes, AllWorkersGetWork) {
    Dispatcher dispatcher = make(GetParam());
    evaluate(dispatcher, sample_work(20), keep());
    std::set<std::uint32_t> workers;
    for (const auto& [slot, outcome] : outcomes) workers.insert(outcome.worker);
    EXPECT_EQ(static_cast<int>(workers.size()), GetParam());
}

TEST_P(DispatcherOfFakes, FailureOfTheMachineRecordsNoRow) {
    Dispatcher dispatcher = make(GetParam());
    std::vector<Work> work = sample_work(100);
    work[20].task.slot = FakeEvaluator::starved_slot;
    try {
        evaluate(dispatcher, work, keep());
        ADD_FAILURE() << "no error was thrown";
    } catch (const Error& error) {
        EXPECT_NE(
            std::string(error.what())
                .find(" could not evaluate finalist 1006 on " + host_name() +
                      ": not enough memory; the machine failed"),
            std::string::npos)
            << error.what();
    }
    EXPECT_FALSE(outcomes.contains(FakeEvaluator::starved_slot));
    // The work in progress was recorded, and no further work was started.
    EXPECT_GE(outcomes.size(), 20u);
    EXPECT_LE(static_cast<int>(outcomes.size()), 20 + 2 * GetParam());
    for (const auto& [slot, outcome] : outcomes)
        expect_same_outcome(work[slot], outcome);
    EXPECT_TRUE(dispatcher.dismiss());
}

TEST_P(DispatcherOfFakes, StopFinishesOnlyWorkInFlight) {
    Dispatcher dispatcher = make(GetParam());
    const Record keep_outcome = keep();
    evaluate(dispatcher, sample_work(100),
             [&](const Work& item, const Outcome& outcome) {
                 keep_outcome(item, outcome);
                 if (outcomes.size() == 3) std::raise(SIGUSR1);
             });
    EXPECT_EQ(static_cast<int>(outcomes.size()), 3 + GetParam() - 1);
    evaluate(dispatcher, sample_work(5), [](const Work&, const Outcome&) {
        ADD_FAILURE() << "new work after a stop was requested";
    });
}

TEST_P(DispatcherOfFakes, DispatcherSurvivesARecordThatThrows) {
    Dispatcher dispatcher = make(GetParam());
    const auto disk_full = [](const Work&, const Outcome&) {
        throw Error("no space left on device");
    };
    EXPECT_THROW(evaluate(dispatcher, sample_work(50), disk_full), Error);
    // Late replies to the failed batch must not be taken for replies to this
    // batch.
    const std::vector<Work> work = sample_work(20, 3);
    evaluate(dispatcher, work, keep());
    expect_all(work);
}

}  // namespace ideotype
