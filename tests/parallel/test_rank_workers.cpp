// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <mpi.h>

#include "command_fixture.hpp"
#include "fake_director.hpp"
#include "ideotype/core/error.hpp"
#include "sample_work.hpp"

namespace ideotype {

using std::chrono::milliseconds;

class RankWorkersOnAllRanks : public Commanded, public Kept {
  protected:
    void set_duration(milliseconds duration) {
        evaluator_ = FakeEvaluator(duration);
    }
};

TEST_F(RankWorkersOnAllRanks, WidthIsTheNumberOfWorkers) {
    command([&](Dispatcher& dispatcher) {
        EXPECT_EQ(dispatcher.width(),
                  session().size() == 1 ? 1 : session().size() - 1);
    });
}

TEST_F(RankWorkersOnAllRanks, EveryTaskIsRecordedOnceWithTheSameNumbers) {
    command([&](Dispatcher& dispatcher) {
        const std::vector<Work> work = sample_work(203);
        evaluate(dispatcher, work, keep());
        expect_all(work);
    });
}

TEST_F(RankWorkersOnAllRanks, GenomesMayHaveAnyLength) {
    command([&](Dispatcher& dispatcher) {
        for (const std::size_t genes : {0u, 1u, 20'000u}) {
            const std::vector<Work> work = sample_work(12, genes);
            outcomes.clear();
            evaluate(dispatcher, work, keep());
            expect_all(work);
        }
    });
}

TEST_F(RankWorkersOnAllRanks, AllWorkersGetWork) {
    set_duration(milliseconds(5));
    command([&](Dispatcher& dispatcher) {
        evaluate(dispatcher, sample_work(20), keep());
        std::set<std::uint32_t> workers;
        for (const auto& [slot, outcome] : outcomes) {
            workers.insert(outcome.worker);
            EXPECT_GE(outcome.seconds, 0.005);
        }
        EXPECT_EQ(static_cast<int>(workers.size()), dispatcher.width());
        EXPECT_EQ(*workers.begin(), session().size() == 1 ? 0u : 1u);
    });
}

TEST_F(RankWorkersOnAllRanks, FailuresArePassedOnWithTheirReasons) {
    command([&](Dispatcher& dispatcher) {
        std::vector<Work> work = sample_work(10);
        work[2].task.slot = FakeEvaluator::throwing_slot;
        work[8].task.slot = FakeEvaluator::not_a_number_slot;
        evaluate(dispatcher, work, keep());
        ASSERT_EQ(outcomes.size(), 10u);
        for (const auto& [slot, outcome] : outcomes)
            EXPECT_EQ(outcome.status,
                      slot < 10 ? Status::done : Status::failed);
        EXPECT_EQ(outcomes.at(FakeEvaluator::throwing_slot).message,
                  "leaf 3 is longer than the row");
        EXPECT_NE(outcomes.at(FakeEvaluator::not_a_number_slot)
                      .message.find("height"),
                  std::string::npos);
    });
}

TEST_F(RankWorkersOnAllRanks, LateEvaluationIsRetriedElsewhere) {
    evaluator_ = FakeEvaluator(milliseconds(0), milliseconds(600));
    command(
        [&](Dispatcher& dispatcher) {
            std::vector<Work> work = sample_work(4);
            work[0].task.slot = FakeEvaluator::slow_once_slot;
            evaluate(dispatcher, work, keep());
            ASSERT_EQ(outcomes.size(), 4u);
            EXPECT_NE(outcomes.at(FakeEvaluator::slow_once_slot).worker, 1u);
        },
        {0.2, 3, 1});
}

TEST_F(RankWorkersOnAllRanks, WorkersAreDividedAmongMasters) {
    set_duration(milliseconds(2));
    const int part = session().rank() % 2;
    const Session half = session().split(part);
    if (half.rank() != 0) return serve(half, {&evaluator_});
    const auto dispatcher = make_dispatcher(half, {&evaluator_}, stop_);
    evaluate(*dispatcher, sample_work(40), keep());
    std::set<std::uint32_t> ranks;
    for (const auto& [slot, outcome] : outcomes) ranks.insert(outcome.worker);
    EXPECT_EQ(ranks.size(), static_cast<std::size_t>(dispatcher->width()));
    for (const std::uint32_t rank : ranks)
        EXPECT_EQ(static_cast<int>(rank % 2), part);
}

TEST_F(RankWorkersOnAllRanks, RanksMayHaveSeveralThreads) {
    FakeEvaluator one(milliseconds(5)), other(milliseconds(5));
    const Evaluators evaluators{&one, &other};
    if (!is_master()) return serve(session(), evaluators);
    const auto dispatcher = make_dispatcher(session(), evaluators, stop_);
    EXPECT_EQ(dispatcher->width(), 2 * session().size());
    const std::vector<Work> work = sample_work(200);
    evaluate(*dispatcher, work, keep());
    expect_all(work);
    std::set<std::uint32_t> workers;
    for (const auto& [slot, outcome] : outcomes) workers.insert(outcome.worker);
    EXPECT_EQ(static_cast<int>(workers.size()), dispatcher->width());
    EXPECT_EQ(static_cast<int>(*workers.rbegin()), dispatcher->width() - 1);
}

TEST_F(RankWorkersOnAllRanks, MasterSleepsWhileItWaits) {
    set_duration(milliseconds(1000));
    const double before = cpu_seconds();
    command([&](Dispatcher& dispatcher) {
        evaluate(dispatcher, sample_work(1), keep());
    });
    EXPECT_LT(cpu_seconds() - before, 0.25);
}

TEST_F(RankWorkersOnAllRanks, WorkersRefuseUnknownMessages) {
    if (!is_master()) {
        EXPECT_THROW(serve(session(), {&evaluator_}), Error);
        EXPECT_THROW(serve(session(), {&evaluator_}), Error);
        return;
    }
    const int number = 5;
    for (int rank = 1; rank < session().size(); ++rank)
        for (const int tag : {1, 99})
            MPI_Send(&number, 1, MPI_INT, rank, tag, MPI_COMM_WORLD);
}

}  // namespace ideotype
