// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! Returns the words as one line that a shell takes apart again as they were.
std::string quoted(const std::vector<std::string>& words);

//! Returns whether a line, which may come from a history of unknown origin, is
//! as quoted() writes it and does nothing in a shell but start a run of
//! ideotype.
bool is_start(const std::string& line);

//! Returns the line that goes on with a run, started as it was: under mpirun if
//! it had several ranks.
//! @param command the quoted command line of the run
std::string way_on(const std::string& command, int ranks);

}  // namespace ideotype
