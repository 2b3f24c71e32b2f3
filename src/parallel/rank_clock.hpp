// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace ideotype {

//! The clock that ranks of a job use. Tests replace it to simulate machines.
class RankClock {
  public:
    virtual ~RankClock() = default;

    //! Returns the time since a fixed moment [s]; it never decreases.
    virtual double now() const = 0;

    //! Sleeps for about a number of seconds.
    virtual void nap(double seconds) const = 0;
};

//! The clock of this machine.
class MachineClock : public RankClock {
  public:
    double now() const override {
        using Steady = std::chrono::steady_clock;
        return std::chrono::duration<double>(Steady::now().time_since_epoch())
            .count();
    }

    void nap(double seconds) const override {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    }
};

inline const MachineClock machine_clock;

//! The pauses between checks while waiting for MPI; blocking calls of MPI would
//! occupy a core. Pauses grow with the time waited so far, so that the end of
//! the wait is noticed with a delay of a few percent.
class Backoff {
  public:
    //! Returns the next pause [s].
    double next() {
        return std::exchange(pause_, std::min(pause_ + pause_ / 32, longest));
    }

  private:
    static constexpr double longest = 1e-3;
    double pause_ = 50e-6;
};

}  // namespace ideotype
