// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace ideotype {

//! The time as the ranks of a job know it. A simulated machine has a clock of
//! its own.
class RankClock {
  public:
    virtual ~RankClock() = default;

    //! Returns the time since some moment, which never runs back [s].
    virtual double now() const = 0;

    //! Does nothing for about this time [s].
    virtual void nap(double seconds) const = 0;
};

//! The time of this machine.
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

//! The rests of somebody who waits for MPI, where a call that blocks would burn
//! a core. They grow with the time waited so far, so that the end of the wait
//! is noticed within a few percent of the time that it took.
class Backoff {
  public:
    //! Returns the next rest [s].
    double next() {
        return std::exchange(rest_, std::min(rest_ + rest_ / 32, longest));
    }

  private:
    static constexpr double longest = 1e-3;
    double rest_ = 50e-6;
};

}  // namespace ideotype
