// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "parallel/session.hpp"

namespace ideotype {

//! Most threads that `--threads` starts.
inline constexpr int most_threads = 4096;

//! Reads how many threads "3" or "auto" stands for.
//! @throws Error of wrong usage.
int parse_threads(const std::string& text);

//! What an MPI launcher, such as mpirun or srun, told this process.
struct Launch {
    bool is_launched = false;
    int rank = 0;
    int size = 1;
};

//! Asks the environment, so that MPI need not be started for it.
Launch launch_of_this_process();

//! Starts MPI if a launcher has started this process; it is not needed else.
//! @throws Error of wrong usage if the ranks do not find each other.
Session start_session();

}  // namespace ideotype
