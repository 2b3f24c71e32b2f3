// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! Whether launch() started this process.
bool is_own_launch();

//! Tells launch(), if that started this process, what rank 0 ends with.
void tell_launcher(ExitCode code);

//! Starts this program again, with so many ranks, under the MPI launcher that
//! it was built with, and waits for its end. The first SIGINT, SIGTERM or
//! SIGUSR1 is passed on as the request to stop after the work in flight; a
//! second SIGINT ends all ranks. Returns the exit code of the ranks.
//! @param words of the command line, the program's name first
//! @param way_on what goes on after ranks were lost
//! @throws Error if there is no launcher.
int launch(int ranks, const std::vector<std::string>& words,
           const std::string& way_on);

}  // namespace ideotype
