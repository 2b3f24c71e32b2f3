#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

namespace ideotype {

//! Waiting that costs little: a call of MPI that blocks would burn a core.
//! Rests grow with the time waited so far, so that what is waited for is
//! noticed within a few percent of the time that it took.
class Backoff {
  public:
    void wait() {
        std::this_thread::sleep_for(nap_);
        nap_ = std::min(nap_ + nap_ / 32, longest);
    }

  private:
    using Nanoseconds = std::chrono::nanoseconds;
    static constexpr Nanoseconds longest = std::chrono::microseconds(1000);
    Nanoseconds nap_ = std::chrono::microseconds(50);
};

}  // namespace ideotype
