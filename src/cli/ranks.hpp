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

//! The largest number of threads that `--threads` accepts.
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

//! Reads rank and size from the environment, without starting MPI.
Launch launch_of_this_process();

//! Returns the folder in /proc of the mpirun that started this process,
//! directly or (MPICH) through an intermediate process; nothing on another
//! node, where the parent is a daemon.
std::optional<std::string> process_of_mpirun();

//! Returns the words before the program in the command line of mpirun, quoted
//! for the shell. Returns "" if mpirun did not start this process, on another
//! node, or if a script is in between.
//! @param program the name with which this process was called
std::string launcher_of(const std::string& program);

//! Starts MPI if a launcher has started this process.
//! @throws Error (usage) if the ranks cannot find each other.
Session start_session();

//! Runs an action on all ranks and reports its error. Before rank 0 throws an
//! Error, it lets all ranks leave. Any other failure aborts the whole job,
//! since the remaining ranks would wait for ever.
ExitCode on_ranks(const Session& session, const Log& log,
                  const std::function<ExitCode()>& action);

//! Runs `direct` on rank 0 with a dispatcher to the evaluators of all ranks;
//! other ranks evaluate.
//! @throws any exception of `direct`, after the workers have left.
ExitCode share_work(const Session& session, const Evaluators& evaluators,
                    const StopFlag& stop, const AnswerRules& rules,
                    const std::function<ExitCode(Dispatcher&)>& direct);

}  // namespace ideotype
