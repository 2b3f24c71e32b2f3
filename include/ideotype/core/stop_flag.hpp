#pragma once

#include <csignal>

namespace ideotype {

//! Turns SIGINT, SIGTERM and SIGUSR1 into a request to stop after the work
//! in flight. A second SIGINT ends the process at once. Signal handlers are
//! a property of the process: only one StopFlag may exist at a time. The
//! former handlers come back with its destruction.
class StopFlag {
  public:
    StopFlag();
    ~StopFlag();
    StopFlag(const StopFlag&) = delete;
    StopFlag& operator=(const StopFlag&) = delete;

    //! True once a signal arrived or request() was called.
    bool requested() const;

    //! Ask to stop, as a signal would.
    void request();

    //! The signal that asked first, 0 if none did.
    int signal() const;

  private:
    struct sigaction former_[3];
};

}  // namespace ideotype
