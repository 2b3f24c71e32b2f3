// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/core/routine.hpp"

namespace ideotype {

namespace {

//! Pauses every routine that awaits it until resume() is called.
struct Gate {
    bool await_ready() const { return false; }
    void await_suspend(std::coroutine_handle<> handle) { awaiting = handle; }
    void await_resume() const {}
    void resume() { awaiting.resume(); }

    std::coroutine_handle<> awaiting;
};

Routine<int> inner(Gate& gate, int value) {
    co_await gate;
    if (value < 0) throw std::runtime_error("negative");
    co_return 2 * value;
}

Routine<std::string> outer(Gate& gate, int value) {
    const int twice = co_await inner(gate, value);
    co_await gate;
    co_return std::to_string(twice);
}

Routine<bool> holding(Gate& gate, std::shared_ptr<int> held) {
    co_await gate;
    co_return *held > 0;
}

}  // namespace

TEST(Routine, RoutineWaitsForItsStart) {
    Gate gate;
    auto routine = outer(gate, 21);
    EXPECT_FALSE(gate.awaiting);
    routine.start();
    EXPECT_TRUE(gate.awaiting);
    EXPECT_FALSE(routine.has_ended());
}

TEST(Routine, PauseSuspendsAllAwaitingRoutines) {
    Gate gate;
    auto routine = outer(gate, 21);
    routine.start();
    gate.resume();
    EXPECT_FALSE(routine.has_ended());
    gate.resume();
    ASSERT_TRUE(routine.has_ended());
    EXPECT_EQ(routine.result(), "42");
}

TEST(Routine, ExceptionsPassToTheAwaitingRoutine) {
    Gate gate;
    auto routine = outer(gate, -1);
    routine.start();
    gate.resume();
    ASSERT_TRUE(routine.has_ended());
    EXPECT_THROW(routine.result(), std::runtime_error);
}

TEST(Routine, DestroyedRoutineReleasesItsArguments) {
    const auto held = std::make_shared<int>(1);
    Gate gate;
    {
        auto routine = holding(gate, held);
        routine.start();
        EXPECT_EQ(held.use_count(), 2);
    }
    EXPECT_EQ(held.use_count(), 1);
}

}  // namespace ideotype
