// SPDX-License-Identifier: Apache-2.0
#include "rank_clock.hpp"

#include <chrono>
#include <thread>

namespace ideotype {

namespace {

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

}  // namespace

const RankClock& machine_clock() {
    static const MachineClock clock;
    return clock;
}

}  // namespace ideotype
