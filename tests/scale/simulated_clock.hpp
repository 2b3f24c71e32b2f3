// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parallel/rank_clock.hpp"

namespace ideotype {

//! The clock of the simulated machine, the same for all ranks.
class SimulatedClock : public RankClock {
  public:
    //! @param slack the time by which a nap is longer than asked for [s]
    explicit SimulatedClock(double slack) : slack_(slack) {}

    double now() const override;
    void nap(double seconds) const override;

    //! Computes for exactly this time [s].
    static void spend(double seconds);

  private:
    double slack_;
};

}  // namespace ideotype
