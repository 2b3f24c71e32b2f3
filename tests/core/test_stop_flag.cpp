// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "ideotype/core/stop_flag.hpp"

namespace ideotype {

namespace {

//! Runs a function in a child process and returns its exit status.
template <class Function>
int run_child(Function run) {
    const pid_t child = fork();
    if (child == 0) {
        run();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

void (*get_handler(int signal))(int) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    return action.sa_handler;
}

void some_handler(int) {}

}  // namespace

class StopSignal : public testing::TestWithParam<int> {};

TEST(StopFlag, StopIsNotRequestedInitially) {
    const StopFlag stop;
    EXPECT_FALSE(stop.requested());
    EXPECT_EQ(stop.signal(), 0);
}

TEST(StopFlag, RequestNeedsNoSignal) {
    StopFlag stop;
    stop.request();
    EXPECT_TRUE(stop.requested());
    EXPECT_EQ(stop.signal(), 0);
}

TEST(StopFlag, StopIsRequestedAfterItsTime) {
    StopFlag stop;
    for (const double endless : {3600.0, 1e10, 1e300}) {
        stop.request_after(endless);
        EXPECT_FALSE(stop.requested());
    }
    stop.request_after(0.01);
    usleep(20'000);
    EXPECT_TRUE(stop.requested());
    EXPECT_EQ(stop.signal(), 0);
}

TEST_P(StopSignal, SignalRequestsAStopAndIsReported) {
    const StopFlag stop;
    raise(GetParam());
    EXPECT_TRUE(stop.requested());
    EXPECT_EQ(stop.signal(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(StopFlag, StopSignal,
                         testing::Values(SIGINT, SIGTERM, SIGUSR1));

TEST(StopFlag, FirstOfSeveralSignalsIsReported) {
    const StopFlag stop;
    raise(SIGUSR1);
    raise(SIGTERM);
    raise(SIGTERM);
    raise(SIGINT);
    EXPECT_EQ(stop.signal(), SIGUSR1);
}

TEST(StopFlag, NewFlagIsIndependentOfAnEarlierOne) {
    {
        const StopFlag stop;
        raise(SIGINT);
    }
    const StopFlag stop;
    EXPECT_FALSE(stop.requested());
    EXPECT_EQ(stop.signal(), 0);
    // This flag has registered only one interrupt so far.
    raise(SIGINT);
    EXPECT_EQ(stop.signal(), SIGINT);
}

TEST(StopFlag, FormerHandlersAreRestored) {
    const auto original = signal(SIGUSR1, some_handler);
    const auto interrupt_handler = get_handler(SIGINT);
    const auto termination_handler = get_handler(SIGTERM);
    {
        const StopFlag stop;
        EXPECT_NE(get_handler(SIGUSR1), some_handler);
    }
    EXPECT_EQ(get_handler(SIGUSR1), some_handler);
    signal(SIGUSR1, original);
    EXPECT_EQ(get_handler(SIGINT), interrupt_handler);
    EXPECT_EQ(get_handler(SIGTERM), termination_handler);
}

TEST(StopFlag, SecondInterruptEndsTheProcessAtOnce) {
    const int once = run_child([] {
        const StopFlag stop;
        raise(SIGINT);
        _exit(stop.requested() ? 5 : 6);
    });
    ASSERT_TRUE(WIFEXITED(once));
    EXPECT_EQ(WEXITSTATUS(once), 5);

    const int twice = run_child([] {
        const StopFlag stop;
        raise(SIGINT);
        raise(SIGINT);
        _exit(5);
    });
    ASSERT_TRUE(WIFEXITED(twice));
    EXPECT_EQ(WEXITSTATUS(twice), 128 + SIGINT);
}

TEST(StopFlag, InterruptedReadContinues) {
    int pipe_ends[2];
    ASSERT_EQ(pipe(pipe_ends), 0);
    const StopFlag stop;
    const pid_t child = fork();
    if (child == 0) {
        // The pause lets the parent begin its read.
        usleep(100'000);
        kill(getppid(), SIGUSR1);
        usleep(100'000);
        const char byte = 'x';
        _exit(write(pipe_ends[1], &byte, 1) == 1 ? 0 : 1);
    }
    char byte = 0;
    EXPECT_EQ(read(pipe_ends[0], &byte, 1), 1);
    EXPECT_EQ(byte, 'x');
    EXPECT_EQ(stop.signal(), SIGUSR1);
    waitpid(child, nullptr, 0);
    close(pipe_ends[0]);
    close(pipe_ends[1]);
}

}  // namespace ideotype
