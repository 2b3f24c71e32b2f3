// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

namespace ideotype {

//! Rests of who waits for MPI, of which a call that blocks would burn a core.
//! They grow with the time waited so far, so that what is waited for is noticed
//! within a few percent of the time that it took.
class Backoff {
  public:
    //! Tells the next rest [s].
    double next() {
        return std::exchange(rest_, std::min(rest_ + rest_ / 32, longest));
    }

  private:
    static constexpr double longest = 1e-3;
    double rest_ = 50e-6;
};

}  // namespace ideotype
