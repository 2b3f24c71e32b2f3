// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! Joins words into one command line, with each word quoted for the shell.
std::string quoted(const std::vector<std::string>& words);

//! Returns whether a line is of the form that quoted() makes and, in a shell,
//! can only start a run of ideotype. The line may come from an untrusted
//! history.
bool is_start(const std::string& line);

//! Returns the command that resumes a run in the way it was started, with
//! mpirun if there were several ranks.
//! @param command quoted command line of the run
//! @param launcher quoted words before the command; "" if they are unknown
std::string way_on(const std::string& command, int ranks,
                   const std::string& launcher = "");

}  // namespace ideotype
