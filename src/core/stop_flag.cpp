// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/stop_flag.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <unistd.h>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

// State of the signal handler, which can access only static variables. Only one
// StopFlag exists, and uses it.
std::atomic<int> first_signal{0};
std::atomic<bool> interrupted{false};
std::atomic<bool> stop_requested{false};
std::atomic<bool> is_owned{false};
static_assert(std::atomic<int>::is_always_lock_free);

constexpr std::array<int, 3> handled{SIGINT, SIGTERM, SIGUSR1};

void handle_signal(int signal) {
    if (signal == SIGINT && interrupted.exchange(true)) _exit(128 + SIGINT);
    int none = 0;
    first_signal.compare_exchange_strong(none, signal);
    stop_requested.store(true);
}

}  // namespace

StopFlag::StopFlag() {
    IDEOTYPE_EXPECT(!is_owned);
    is_owned = true;
    first_signal = 0;
    interrupted = false;
    stop_requested = false;
    struct sigaction action {};
    action.sa_handler = handle_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < handled.size(); ++i)
        sigaction(handled[i], &action, &former_[i]);
}

StopFlag::~StopFlag() {
    for (std::size_t i = 0; i < handled.size(); ++i)
        sigaction(handled[i], &former_[i], nullptr);
    is_owned = false;
}

bool StopFlag::requested() const {
    return stop_requested.load() || std::chrono::steady_clock::now() >= end_;
}

void StopFlag::request() {
    stop_requested.store(true);
}

void StopFlag::request_after(double seconds) {
    IDEOTYPE_EXPECT(seconds >= 0);
    using std::chrono::steady_clock;
    const steady_clock::time_point now = steady_clock::now();
    const std::chrono::duration<double> wait(seconds);
    constexpr auto never = steady_clock::time_point::max();
    // The clock cannot represent times centuries ahead.
    end_ = wait < (never - now) / 2
               ? now + std::chrono::duration_cast<steady_clock::duration>(wait)
               : never;
}

int StopFlag::signal() const {
    return first_signal.load();
}

}  // namespace ideotype
