// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! The words as one line that a shell takes apart again as they were.
std::string quoted(const std::vector<std::string>& words);

//! The line that goes on with a run, started as it was: under mpirun if it had
//! several ranks, unless `--ranks` is there to start them.
//! @param command the quoted command line of the run
std::string way_on(const std::string& command, int ranks);

}  // namespace ideotype
