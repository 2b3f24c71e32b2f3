// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parallel/rank_clock.hpp"

namespace ideotype {

//! The clock of the simulated machine, the same for all ranks.
class SimulatedClock : public RankClock {
  public:
    //! @param slack excess of the duration of a nap over the requested time [s]
    explicit SimulatedClock(double slack) : slack_(slack) {}

    double now() const override;
    void nap(double seconds) const override;

    //! Spends exactly this time on a computation [s].
    static void spend(double seconds);

  private:
    double slack_;
};

}  // namespace ideotype
