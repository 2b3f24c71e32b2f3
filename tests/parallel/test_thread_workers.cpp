// SPDX-License-Identifier: Apache-2.0
#include <ctime>
#include <deque>
#include <set>

#include "fake_director.hpp"
#include "ideotype/core/error.hpp"
#include "sample_work.hpp"

namespace ideotype {

using std::chrono::milliseconds;

//! Several threads of one process without MPI.
class ThreadWorkers : public testing::TestWithParam<int>, public Kept {
  protected:
    //! Copies an evaluator for each thread.
    std::unique_ptr<Dispatcher> make(const FakeEvaluator& evaluator,
                                     const AnswerRules& rules = {}) {
        Evaluators evaluators;
        for (int i = 0; i < GetParam(); ++i)
            evaluators.push_back(&evaluators_.emplace_back(evaluator));
        return make_dispatcher(session_, evaluators, stop_, rules);
    }

    const Session session_ = Session::alone();
    std::deque<FakeEvaluator> evaluators_;
    StopFlag stop_;
};

INSTANTIATE_TEST_SUITE_P(Threads, ThreadWorkers, testing::Values(1, 2, 7));

TEST_P(ThreadWorkers, OutcomesDoNotDependOnTheThread) {
    const auto dispatcher = make(FakeEvaluator(milliseconds(1)));
    EXPECT_EQ(dispatcher->width(), GetParam());
    const std::vector<Work> work = sample_work(203);
    evaluate(*dispatcher, work, keep());
    expect_all(work);
    std::set<std::uint32_t> workers;
    for (const auto& [slot, outcome] : outcomes) {
        workers.insert(outcome.worker);
        EXPECT_GE(outcome.seconds, 0.001);
    }
    EXPECT_EQ(static_cast<int>(workers.size()), GetParam());
    EXPECT_EQ(static_cast<int>(*workers.rbegin()), GetParam() - 1);
}

TEST_P(ThreadWorkers, FailuresOfPlantAndMachineAreDistinguished) {
    const auto dispatcher = make(FakeEvaluator());
    std::vector<Work> work = sample_work(10);
    work[2].task.slot = FakeEvaluator::throwing_slot;
    evaluate(*dispatcher, work, keep());
    ASSERT_EQ(outcomes.size(), 10u);
    EXPECT_EQ(outcomes.at(FakeEvaluator::throwing_slot).message,
              "leaf 3 is longer than the row");
    work[8].task.slot = FakeEvaluator::starved_slot;
    outcomes.clear();
    EXPECT_THROW(evaluate(*dispatcher, work, keep()), Error);
    EXPECT_FALSE(outcomes.contains(FakeEvaluator::starved_slot));
    EXPECT_TRUE(dispatcher->dismiss());
}

TEST_P(ThreadWorkers, HangingWorkersGetNoWork) {
    const auto dispatcher =
        make(FakeEvaluator(milliseconds(0), milliseconds(500)), {0.1, 3, 1});
    std::vector<Work> work = sample_work(20);
    work[0].task.slot = FakeEvaluator::slow_once_slot;
    FakeDirector director;
    director.add(make_routine(*dispatcher, work, keep()));
    if (GetParam() == 1) {
        EXPECT_THROW(dispatcher->run(director), Error);
    } else {
        dispatcher->run(director);
        EXPECT_EQ(outcomes.size(), 20u);
        EXPECT_NE(outcomes.at(FakeEvaluator::slow_once_slot).worker, 0u);
    }
    EXPECT_EQ(director.silences.size(), 1u);
    EXPECT_FALSE(dispatcher->dismiss());
}

TEST_P(ThreadWorkers, WaitingWorkersUseNoProcessorTime) {
    const auto dispatcher = make(FakeEvaluator(milliseconds(500)));
    const std::clock_t before = std::clock();
    evaluate(*dispatcher, sample_work(1), keep());
    EXPECT_LT(std::clock() - before, CLOCKS_PER_SEC / 10);
}

TEST(SessionAlone, AbortEndsTheProcessDespiteRunningThreads) {
    const Session session = Session::alone();
    EXPECT_EQ(session.gather("own"), std::vector<std::string>{"own"});
    EXPECT_EQ(session.split(3).rank_in_job(0), 0);
    const auto end_with_running_thread = [&] {
        std::thread([] {
            std::this_thread::sleep_for(milliseconds(10'000));
        }).detach();
        session.abort(5);
    };
    EXPECT_EXIT(end_with_running_thread(), testing::ExitedWithCode(5), "");
}

}  // namespace ideotype
