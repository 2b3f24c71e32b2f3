// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! Quotes words for the shell, as one line.
std::string quoted(const std::vector<std::string>& words);

//! Returns whether a line has the form of quoted() and, in a shell, can only
//! start a run of ideotype. The line may come from a history of unknown origin.
bool is_start(const std::string& line);

//! Returns the command that resumes a run as it was started, under mpirun if it
//! had several ranks.
//! @param command the quoted command line of the run
//! @param launcher quoted words before the command; "" if they are unknown
std::string way_on(const std::string& command, int ranks,
                   const std::string& launcher = "");

}  // namespace ideotype
