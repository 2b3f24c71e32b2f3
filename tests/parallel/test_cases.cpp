// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "fake_workers.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

std::vector<Work> make_generation(std::uint32_t case_index,
                                  std::uint32_t generation,
                                  std::uint32_t population) {
    std::vector<Work> work;
    for (std::uint32_t slot = 0; slot < population; ++slot)
        work.push_back({{case_index, generation, slot}, {1.0, 2.0}});
    return work;
}

}  // namespace

//! Several routines in one run, like the cases of a sweep.
class Cases : public WithAnyWorkers {
  protected:
    //! Runs commands with a new dispatcher of fake workers.
    template <class Command>
    void command(Command give_orders) {
        Dispatcher dispatcher = make(GetParam());
        give_orders(dispatcher);
    }

    //! Evaluates one generation after the other and stores the order in which
    //! outcomes arrive.
    Routine<bool> evolve(Dispatcher& dispatcher, std::uint32_t case_index,
                         std::uint32_t generations, std::uint32_t population) {
        for (std::uint32_t g = 0; g < generations; ++g) {
            std::uint32_t arrived = 0;
            const Record record = [&](const Work& work, const Outcome&) {
                EXPECT_EQ(work.task.case_index, case_index);
                EXPECT_EQ(work.task.generation, g);
                order_.push_back(case_index);
                ++arrived;
            };
            co_await dispatcher.evaluate(
                make_generation(case_index, g, population), record);
            if (stop_.requested()) co_return false;
            EXPECT_EQ(arrived, population);
        }
        co_return true;
    }

    std::size_t count(std::uint32_t case_index) const {
        return static_cast<std::size_t>(
            std::count(order_.begin(), order_.end(), case_index));
    }

    std::vector<std::uint32_t> order_;  //!< cases by the arrival of outcomes
};

INSTANTIATE_TEST_SUITE_P(Workers, Cases, testing::Values(1, 2, 8));

TEST_P(Cases, AllCasesAreEvaluatedCompletely) {
    command([&](Dispatcher& dispatcher) {
        for (std::uint32_t c = 0; c < 4; ++c)
            director_.add(evolve(dispatcher, c, 3, 5 + c));
        dispatcher.run(director_);
        for (std::uint32_t c = 0; c < 4; ++c) EXPECT_EQ(count(c), 3 * (5 + c));
        for (auto& routine : director_.started) EXPECT_TRUE(routine.result());
    });
}

// Each row becomes available only after the outcome of the third row before it.
TEST_P(Cases, WorkMayDependOnOutcomes) {
    constexpr std::uint32_t rows = 40, cases = 4;
    std::vector<std::uint32_t> given(cases), answered(cases);
    const auto evolve_rows = [&](Dispatcher& dispatcher,
                                 std::uint32_t c) -> Routine<bool> {
        const NextWork next = [&given, &answered, c]() -> std::optional<Work> {
            if (given[c] == rows || given[c] >= answered[c] + 3)
                return std::nullopt;
            const std::uint32_t row = given[c]++;
            return Work{{c, row / 10, row % 10}, {1.0, 2.0}};
        };
        const Record record = [&answered, c](const Work& work, const Outcome&) {
            EXPECT_EQ(work.task.case_index, c);
            ++answered[c];
        };
        co_await dispatcher.evaluate(next, record);
        co_return answered[c] == rows;
    };
    command([&](Dispatcher& dispatcher) {
        for (std::uint32_t c = 0; c < cases; ++c)
            director_.add(evolve_rows(dispatcher, c));
        dispatcher.run(director_);
        ASSERT_EQ(director_.started.size(), cases);
        for (auto& routine : director_.started) EXPECT_TRUE(routine.result());
    });
}

TEST_P(Cases, FailingSourceEndsOnlyItsRoutine) {
    command([&](Dispatcher& dispatcher) {
        const auto failing = [&]() -> Routine<bool> {
            std::uint32_t slot = 0;
            const NextWork next = [&slot]() -> std::optional<Work> {
                if (slot == 5) throw Error("no space left on device");
                return Work{{0, 0, slot++}, {1.0, 2.0}};
            };
            const Record record = [](const Work&, const Outcome&) {};
            co_await dispatcher.evaluate(next, record);
            co_return true;
        };
        director_.add(failing());
        director_.add(evolve(dispatcher, 1, 2, 10));
        dispatcher.run(director_);
        EXPECT_EQ(count(1), 20u);
        EXPECT_THROW(director_.started.front().result(), Error);
        EXPECT_TRUE(director_.started.back().result());
    });
}

TEST_P(Cases, CasesStartOnlyWhenWorkersWouldBeIdle) {
    command([&](Dispatcher& dispatcher) {
        const std::size_t width = static_cast<std::size_t>(dispatcher.width());
        std::size_t started_at_first = 0;
        const Record record = [&](const Work&, const Outcome&) {
            if (started_at_first == 0)
                started_at_first = director_.started.size();
        };
        // Each case occupies two workers.
        for (std::uint32_t c = 0; c < 9; ++c)
            director_.add(
                make_routine(dispatcher, make_generation(c, 0, 2), record));
        dispatcher.run(director_);
        EXPECT_EQ(started_at_first, (width + 1) / 2);
        EXPECT_EQ(director_.started.size(), 9u);
    });
}

TEST_P(Cases, CasesStartedTogetherEndTogether) {
    command([&](Dispatcher& dispatcher) {
        for (std::uint32_t c = 0; c < 3; ++c)
            director_.add(evolve(dispatcher, c, 4, 24));
        dispatcher.run(director_);
        const auto end_of_first =
            std::find(order_.rbegin(), order_.rend(), 0u).base();
        const auto of_second = std::count(order_.begin(), end_of_first, 1u);
        if (dispatcher.width() == 1)
            EXPECT_EQ(of_second, 0);
        else
            EXPECT_GE(of_second, 2 * 24);
        EXPECT_EQ(order_.front(), 0u);
    });
}

TEST_P(Cases, FailingCaseDoesNotAffectTheOthers) {
    command([&](Dispatcher& dispatcher) {
        const Record disk_full = [](const Work&, const Outcome&) {
            throw Error("no space left on device");
        };
        director_.add(
            make_routine(dispatcher, make_generation(0, 0, 20), disk_full));
        director_.add(evolve(dispatcher, 1, 2, 10));
        dispatcher.run(director_);
        EXPECT_EQ(count(1), 20u);
        EXPECT_THROW(director_.started.front().result(), Error);
        EXPECT_TRUE(director_.started.back().result());
    });
}

TEST_P(Cases, StopIsReportedOnceAndDrainsAllCases) {
    command([&](Dispatcher& dispatcher) {
        const Record stop_at_once = [&](const Work&, const Outcome&) {
            stop_.request();
        };
        for (std::uint32_t c = 0; c < 3; ++c)
            director_.add(make_routine(dispatcher, make_generation(c, 0, 30),
                                       stop_at_once));
        dispatcher.run(director_);
        EXPECT_EQ(director_.stops, std::vector{dispatcher.width() - 1});
        for (auto& routine : director_.started)
            EXPECT_TRUE(routine.has_ended());
    });
}

}  // namespace ideotype
