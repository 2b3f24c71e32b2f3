// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "ideotype/parallel/rank_clock.hpp"

namespace ideotype {

//! Waiting that costs little: a call of MPI that blocks would burn a core.
//! Rests grow with the time waited so far, so that what is waited for is
//! noticed within a few percent of the time that it took.
class Backoff {
  public:
    explicit Backoff(const RankClock& clock) : clock_(clock) {}

    void wait() {
        clock_.nap(nap_);
        nap_ = std::min(nap_ + nap_ / 32, longest);
    }

  private:
    static constexpr double longest = 1e-3;
    const RankClock& clock_;
    double nap_ = 50e-6;  //!< the next [s]
};

}  // namespace ideotype
