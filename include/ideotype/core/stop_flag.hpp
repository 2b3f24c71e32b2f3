// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <csignal>

namespace ideotype {

//! Turns SIGINT, SIGTERM and SIGUSR1 into a request to stop after the work in
//! flight. A second SIGINT ends the process at once. Signal handlers are a
//! property of the process: only one StopFlag may exist at a time. Its
//! destructor restores the former handlers.
class StopFlag {
  public:
    StopFlag();
    ~StopFlag();
    StopFlag(const StopFlag&) = delete;
    StopFlag& operator=(const StopFlag&) = delete;

    //! Returns whether a signal arrived, request() was called or the time of
    //! request_after() is over.
    bool requested() const;

    //! Asks to stop, as a signal would.
    void request();

    //! Asks to stop after a time [s], which does not depend on changes of the
    //! system clock.
    void request_after(double seconds);

    //! Returns the signal that asked first, or 0 if none did.
    int signal() const;

  private:
    std::chrono::steady_clock::time_point end_ =
        std::chrono::steady_clock::time_point::max();
    struct sigaction former_[3];
};

}  // namespace ideotype
