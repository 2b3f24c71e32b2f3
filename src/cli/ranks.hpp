// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ideotype/core/error.hpp"
#include "parallel/dispatcher.hpp"
#include "parallel/session.hpp"
#include "run/log.hpp"

namespace ideotype {

//! The largest number of threads for `--threads`.
inline constexpr int most_threads = 4096;

//! Parses a number of threads such as "3" or "auto".
//! @throws Error (usage) for other texts.
int parse_threads(const std::string& text);

//! The rank of this process in an MPI job started by mpirun or srun.
struct Launch {
    bool is_launched = false;
    int rank = 0;
    int size = 1;
};

//! Reads the rank and the number of ranks from the environment, without
//! starting MPI.
Launch launch_of_this_process();

//! Returns the folder in /proc of the mpirun that started this process,
//! directly or (MPICH) through an intermediate process. Returns nothing if
//! mpirun runs on another node; the parent is then a daemon.
std::optional<std::string> process_of_mpirun();

//! Returns the words that precede the program in the command line of mpirun,
//! quoted for the shell. Returns "" if mpirun did not start this process, runs
//! on another node, or started it through a script.
//! @param program name with which this process was called
std::string launcher_of(const std::string& program);

//! Starts MPI if a launcher started this process.
//! @throws Error (usage) if the ranks cannot find each other.
Session start_session();

//! Runs a function on all ranks and reports its error. On rank 0, the function
//! may throw an Error only after it has released the other ranks. Any other
//! failure aborts the whole job, since the remaining ranks would wait for ever.
ExitCode on_ranks(const Session& session, const Log& log,
                  const std::function<ExitCode()>& action);

//! Runs `direct` on rank 0 with a dispatcher to the evaluators of all ranks;
//! the other ranks evaluate.
//! @throws any exception of `direct`, after the workers have been released.
ExitCode share_work(const Session& session, const Evaluators& evaluators,
                    const StopFlag& stop, const AnswerRules& rules,
                    const std::function<ExitCode(Dispatcher&)>& direct);

}  // namespace ideotype
