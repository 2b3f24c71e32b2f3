// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <csignal>

namespace ideotype {

//! Turns SIGINT, SIGTERM and SIGUSR1 into a request to stop after the current
//! work. A second SIGINT ends the process at once. Signal handlers belong to
//! the process, so only one StopFlag may exist at a time. Its destructor
//! restores the previous handlers.
class StopFlag {
  public:
    StopFlag();
    ~StopFlag();
    StopFlag(const StopFlag&) = delete;
    StopFlag& operator=(const StopFlag&) = delete;

    //! Returns whether a signal has arrived, request() was called or the time
    //! of request_after() has passed.
    bool requested() const;

    //! Requests a stop, as a signal would.
    void request();

    //! Requests a stop after a time [s]. Changes of the system clock have no
    //! effect.
    void request_after(double seconds);

    //! Returns the signal that arrived first, or 0 if none did.
    int signal() const;

  private:
    std::chrono::steady_clock::time_point end_ =
        std::chrono::steady_clock::time_point::max();
    struct sigaction former_[3];
};

}  // namespace ideotype
