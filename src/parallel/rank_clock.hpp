// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace ideotype {

//! The clock of the ranks of a job; simulated machines replace it.
class RankClock {
  public:
    virtual ~RankClock() = default;

    //! Returns the time since a fixed moment [s]; it never decreases.
    virtual double now() const = 0;

    //! Sleeps for about a time [s].
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

//! The pauses between checks while waiting for MPI, whose blocking calls would
//! occupy a core. Pauses grow with the time waited, so that the end is noticed
//! within a few percent of the duration of the wait.
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
