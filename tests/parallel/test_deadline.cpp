// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>

#include "fake_workers.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

//! Workers that exceed their deadline; slow work takes 6 deadlines.
class Deadline : public WithFakeWorkers {
  protected:
    static constexpr std::uint32_t slow_once = 4, slow = 5;
    static constexpr AnswerRules impatient{0.2, 1};

    Deadline() {
        duration_ = [](int, const Work& work) {
            const Task& task = work.task;
            return task.slot == slow ||
                           (task.slot == slow_once && task.attempt == 1)
                       ? 1.2
                       : 0.001;
        };
    }

    //! Evaluates the given slots and stores the answers.
    void run(Dispatcher& dispatcher, const std::vector<std::uint32_t>& slots) {
        answers_.clear();
        std::vector<Work> work;
        for (const std::uint32_t slot : slots)
            work.push_back({{0, 0, slot}, {1.0, 2.0}});
        director_.add(make_routine(
            dispatcher, work, [this](const Work& item, const Outcome& outcome) {
                EXPECT_TRUE(
                    answers_.emplace(item.task.slot, Answered{item, outcome})
                        .second);
            }));
        dispatcher.run(director_);
    }

    struct Answered {
        Work work;
        Outcome outcome;
    };

    std::map<std::uint32_t, Answered> answers_;  //!< answers by slot
};

TEST_F(Deadline, LateEvaluationIsRetriedElsewhere) {
    Dispatcher dispatcher = make(2, impatient);
    run(dispatcher, {slow_once, 1, 2, 3});
    ASSERT_EQ(answers_.size(), 4u);
    const auto& [work, outcome] = answers_.at(slow_once);
    EXPECT_EQ(work.task.attempt, 2u);
    EXPECT_EQ(outcome.status, Status::done);
    EXPECT_EQ(outcome.worker, 1u);
    EXPECT_EQ(answers_.at(3).work.task.attempt, 1u);
    EXPECT_EQ(director_.silences,
              std::vector<std::string>{"no answer from worker 0 within 0.2 s "
                                       "for generation 0 slot 4, attempt 1; "
                                       "trying again"});
}

TEST_F(Deadline, LateAnswerIsDroppedAndItsWorkerReturns) {
    Dispatcher dispatcher = make(2, impatient);
    run(dispatcher, {slow_once, 1});
    // The late worker gets no work until it answers.
    run(dispatcher, {10, 11, 12, 13});
    ASSERT_EQ(answers_.size(), 4u);
    for (const auto& [slot, answer] : answers_)
        EXPECT_EQ(answer.outcome.worker, 1u);
    clock_.nap(1.2);
    run(dispatcher, {10, 11, 12, 13});
    ASSERT_EQ(answers_.size(), 4u);
    std::set<std::uint32_t> workers;
    for (const auto& [slot, answer] : answers_)
        workers.insert(answer.outcome.worker);
    EXPECT_EQ(workers, (std::set<std::uint32_t>{0, 1}));
    EXPECT_TRUE(dispatcher.dismiss());
}

TEST_F(Deadline, RowFailsAfterTheLastAttempt) {
    Dispatcher dispatcher = make(4, impatient);
    run(dispatcher, {slow, 1, 2});
    ASSERT_EQ(answers_.size(), 3u);
    const auto& [work, outcome] = answers_.at(slow);
    EXPECT_EQ(work.task.attempt, 3u);
    EXPECT_EQ(outcome.status, Status::failed);
    EXPECT_EQ(outcome.message, "no answer within 0.2 s in 3 attempts");
    EXPECT_EQ(director_.silences.size(), 3u);
    EXPECT_FALSE(dispatcher.dismiss());
}

TEST_F(Deadline, FirstAnswerCountsEvenIfLate) {
    duration_ = [](int, const Work& work) {
        return work.task.slot == slow ? 0.3 : 0.001;
    };
    Dispatcher dispatcher = make(2, impatient);
    // The first attempt answers while the second is still running.
    run(dispatcher, {slow, 1, 2});
    ASSERT_EQ(answers_.size(), 3u);
    EXPECT_EQ(answers_.at(slow).work.task.attempt, 1u);
    EXPECT_EQ(answers_.at(slow).outcome.status, Status::done);
    EXPECT_EQ(answers_.at(slow).outcome.worker, 0u);
}

TEST_F(Deadline, RunEndsWithAnErrorWhenNoWorkerAnswers) {
    for (const int width : {1, 2, 3}) {
        director_.silences.clear();
        // No row fails, even if the permitted attempts do not exceed the number
        // of workers.
        Dispatcher dispatcher = make(width, {0.1, 1});
        try {
            run(dispatcher, {slow});
            ADD_FAILURE() << "continued without workers";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("parallel.deadline"),
                      std::string::npos);
        }
        EXPECT_TRUE(answers_.empty());
        EXPECT_EQ(static_cast<int>(director_.silences.size()), width);
        EXPECT_FALSE(dispatcher.dismiss());
        // A paused coroutine must not outlive the dispatcher that it awaits.
        director_.started.clear();
    }
}

TEST_F(Deadline, DrainWaitsForAHungWorkerOnlyUntilItsDeadline) {
    Dispatcher dispatcher = make(2, impatient);
    duration_ = [this](int, const Work&) {
        stop_.request();
        return 1.2;
    };
    run(dispatcher, {1});
    EXPECT_TRUE(answers_.empty());
    EXPECT_TRUE(director_.started.front().has_ended());
    EXPECT_NEAR(clock_.now(), 100.2, 1e-6);
    // The worker still hangs.
    EXPECT_FALSE(dispatcher.dismiss());
}

TEST_F(Deadline, DeadlineGrowsWithTheLongestEvaluation) {
    duration_ = [](int, const Work& work) {
        return work.task.slot == slow ? 0.6 : 0.06;
    };
    Dispatcher dispatcher = make(2, impatient);
    run(dispatcher, {1, 2});
    // The deadline is 20 times the usual 60 ms, since this is more than the
    // requested 200 ms.
    run(dispatcher, {slow});
    EXPECT_TRUE(director_.silences.empty());
    EXPECT_EQ(answers_.at(slow).work.task.attempt, 1u);
}

TEST_F(Deadline, DeadlineDoesNotPassWhileTheJobIsPaused) {
    duration_ = [this](int, const Work& work) {
        if (work.task.slot == 2) clock_.nap(3600);  // as after Ctrl-Z
        return 1.5;
    };
    Dispatcher dispatcher = make(2, {3, 3, 1});
    run(dispatcher, {1, 2});
    EXPECT_EQ(answers_.size(), 2u);
    EXPECT_TRUE(director_.silences.empty());
}

}  // namespace ideotype
