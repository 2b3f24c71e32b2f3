// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Most ranks that `--ranks` starts.
inline constexpr int most_ranks = 4096;

//! Cores that this process may use: those of its affinity, or of the quota of
//! its container if that is less. At least 1.
int available_cores();

//! The ranks that keep all cores busy. Rank 0 sleeps while the others
//! evaluate, so it is one more than cores; on one core rank 0 evaluates alone.
constexpr int ranks_for(int cores) {
    return cores > 1 ? cores + 1 : 1;
}

//! How many ranks "3" or "auto" stands for.
//! @throws Error of wrong usage.
int parse_ranks(const std::string& text);

//! What an MPI launcher, such as mpirun or srun, told this process.
struct Launch {
    bool is_launched = false;
    int rank = 0;
    int size = 1;
};

//! Asks the environment, so that MPI need not be started for it.
Launch launch_of_this_process();

//! Refuses a job of which MPI has found fewer ranks than were started, as it
//! does under the launcher of another MPI: each would do all the work.
//! @throws Error of wrong usage.
void require_all_ranks(int found);

}  // namespace ideotype
