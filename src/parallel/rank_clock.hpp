// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! Time as the ranks of a job know it. That of a simulated machine is another.
class RankClock {
  public:
    virtual ~RankClock() = default;

    //! Since some moment; never runs back [s].
    virtual double now() const = 0;

    //! Does nothing for about this time [s].
    virtual void nap(double seconds) const = 0;
};

//! That of this machine.
const RankClock& machine_clock();

}  // namespace ideotype
