// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "command_fixture.hpp"
#include "fake_director.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

using std::chrono::milliseconds;

//! Workers that do not answer in time. Needs two of them.
class DeadlineOnAllRanks : public Commanded {
  protected:
    DeadlineOnAllRanks()
        : Commanded(FakeEvaluator(milliseconds(0), milliseconds(1200))) {}

    template <class Command>
    void command_two(const AnswerRules& rules, Command give_orders) {
        if (session().size() >= 3) command(give_orders, rules);
    }

    Routine<bool> evaluate_slots(Dispatcher& dispatcher,
                                 std::vector<std::uint32_t> slots) {
        std::vector<Work> work;
        for (const std::uint32_t slot : slots)
            work.push_back({{0, 0, slot}, {1.0, 2.0}});
        return batch_routine(
            dispatcher, work, [this](const Work& item, const Outcome& outcome) {
                EXPECT_TRUE(
                    answers_.emplace(item.task.slot, Answered{item, outcome})
                        .second);
            });
    }

    struct Answered {
        Work work;
        Outcome outcome;
    };

    static constexpr std::uint32_t slow_once = FakeEvaluator::slow_once_slot;
    static constexpr std::uint32_t slow = FakeEvaluator::slow_slot;
    static constexpr AnswerRules impatient{0.2, 3, 1};

    FakeDirector director_;
    std::map<std::uint32_t, Answered> answers_;  //!< by slot
};

TEST_F(DeadlineOnAllRanks, ALateEvaluationIsTriedElsewhere) {
    command_two(impatient, [&](Dispatcher& dispatcher) {
        director_.add(evaluate_slots(dispatcher, {slow_once, 1, 2, 3}));
        dispatcher.run(director_);
        ASSERT_EQ(answers_.size(), 4u);
        const auto& [work, outcome] = answers_.at(slow_once);
        EXPECT_EQ(work.task.attempt, 2u);
        EXPECT_EQ(outcome.status, Status::done);
        EXPECT_NE(outcome.worker, 1u);
        EXPECT_EQ(answers_.at(3).work.task.attempt, 1u);
        ASSERT_EQ(director_.silences.size(), 1u);
        EXPECT_NE(director_.silences[0].find("no answer from rank 1 within"),
                  std::string::npos)
            << director_.silences[0];
    });
}

TEST_F(DeadlineOnAllRanks, ALateAnswerIsDroppedAndItsWorkerIsBack) {
    command_two(impatient, [&](Dispatcher& dispatcher) {
        director_.add(evaluate_slots(dispatcher, {slow_once, 1}));
        dispatcher.run(director_);
        // Until the late one answers it gets no work.
        answers_.clear();
        std::vector<std::uint32_t> slots(20);
        for (std::uint32_t i = 0; i < 20; ++i) slots[i] = i;
        director_.add(evaluate_slots(dispatcher, slots));
        dispatcher.run(director_);
        ASSERT_EQ(answers_.size(), 20u);
        for (const auto& [slot, answer] : answers_)
            EXPECT_NE(answer.outcome.worker, 1u);

        std::this_thread::sleep_for(milliseconds(1200));
        answers_.clear();
        bool is_back = false;
        for (int i = 0; i < 200 && !is_back; ++i) {
            director_.add(evaluate_slots(dispatcher, slots));
            dispatcher.run(director_);
            for (const auto& [slot, answer] : answers_)
                is_back = is_back || answer.outcome.worker == 1u;
            answers_.clear();
        }
        EXPECT_TRUE(is_back);
        EXPECT_TRUE(dispatcher.dismiss());
    });
}

TEST_F(DeadlineOnAllRanks, AfterTheLastAttemptTheRowSaysSo) {
    if (session().size() < 5) return;
    command_two(impatient, [&](Dispatcher& dispatcher) {
        director_.add(evaluate_slots(dispatcher, {slow, 1, 2}));
        dispatcher.run(director_);
        ASSERT_EQ(answers_.size(), 3u);
        const auto& [work, outcome] = answers_.at(slow);
        EXPECT_EQ(work.task.attempt, 3u);
        EXPECT_EQ(outcome.status, Status::failed);
        EXPECT_EQ(outcome.message, "no answer within 0.2 s in 3 attempts");
        EXPECT_EQ(director_.silences.size(), 3u);
        EXPECT_FALSE(dispatcher.dismiss());
    });
}

TEST_F(DeadlineOnAllRanks, TheFirstAnswerCountsEvenIfLate) {
    if (session().size() != 3) return;
    evaluator_ = FakeEvaluator(milliseconds(0), milliseconds(300));
    command_two(impatient, [&](Dispatcher& dispatcher) {
        // The first attempt answers while the second is under way.
        director_.add(evaluate_slots(dispatcher, {slow, 1, 2}));
        dispatcher.run(director_);
        ASSERT_EQ(answers_.size(), 3u);
        EXPECT_EQ(answers_.at(slow).work.task.attempt, 1u);
        EXPECT_EQ(answers_.at(slow).outcome.status, Status::done);
        EXPECT_EQ(answers_.at(slow).outcome.worker, 1u);
    });
}

TEST_F(DeadlineOnAllRanks, EndsWithAnErrorWhenNobodyAnswers) {
    // As many attempts as workers: still no failed row.
    command_two({0.1, session().size() - 1, 1}, [&](Dispatcher& dispatcher) {
        director_.add(evaluate_slots(dispatcher, {slow}));
        try {
            dispatcher.run(director_);
            ADD_FAILURE() << "went on without workers";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("parallel.deadline"),
                      std::string::npos);
        }
        EXPECT_TRUE(answers_.empty());
        EXPECT_EQ(static_cast<int>(director_.silences.size()),
                  dispatcher.width());
        EXPECT_FALSE(dispatcher.dismiss());
        // What pauses must not outlive what it waits for.
        director_.started.clear();
    });
}

TEST_F(DeadlineOnAllRanks, ADrainWaitsForAHungWorkerUntilItsDeadlineOnly) {
    command_two(impatient, [&](Dispatcher& dispatcher) {
        stop_.request_after(0.05);
        director_.add(evaluate_slots(dispatcher, {slow_once}));
        dispatcher.run(director_);
        EXPECT_TRUE(answers_.empty());
        EXPECT_TRUE(director_.started.front().has_ended());
        // It hangs still.
        EXPECT_FALSE(dispatcher.dismiss());
    });
}

TEST_F(DeadlineOnAllRanks, GrowsWithWhatTheLongestTook) {
    evaluator_ = FakeEvaluator(milliseconds(60), milliseconds(600));
    command_two(impatient, [&](Dispatcher& dispatcher) {
        director_.add(evaluate_slots(dispatcher, {1, 2}));
        dispatcher.run(director_);
        // 20 times 60 ms is more than the 200 ms that were asked for.
        director_.add(evaluate_slots(dispatcher, {slow}));
        dispatcher.run(director_);
        EXPECT_TRUE(director_.silences.empty());
        EXPECT_EQ(answers_.at(slow).work.task.attempt, 1u);
    });
}

}  // namespace ideotype
