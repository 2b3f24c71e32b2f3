// SPDX-License-Identifier: Apache-2.0
#include "simulated_clock.hpp"

#include <cmath>
#include <ctime>

#include <mpi.h>
#include <smpi/smpi_helpers_internal.h>

namespace ideotype {

double SimulatedClock::now() const {
    return MPI_Wtime();
}

void SimulatedClock::nap(double seconds) const {
    spend(seconds + slack_);
}

// SMPI measures the time of computations. Its simulated sleep is not counted as
// one, so that exactly the given time passes.
void SimulatedClock::spend(double seconds) {
    if (seconds <= 0) return;
    std::timespec time{};
    time.tv_sec = static_cast<std::time_t>(seconds);
    time.tv_nsec = std::lround(1e9 * (seconds - std::floor(seconds)));
    smpi_nanosleep(&time, nullptr);
}

}  // namespace ideotype
