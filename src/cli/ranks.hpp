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

//! The most threads that `--threads` starts.
inline constexpr int most_threads = 4096;

//! Returns the number of threads that a text such as "3" or "auto" stands for.
//! @throws Error (usage) for other texts.
int parse_threads(const std::string& text);

//! The place of this process among those that an MPI launcher, such as mpirun
//! or srun, has started.
struct Launch {
    bool is_launched = false;
    int rank = 0;
    int size = 1;
};

//! Reads the place of this process from the environment, without starting MPI.
Launch launch_of_this_process();

//! Returns the folder of mpirun in /proc, if it started this process, by itself
//! or, as MPICH does, by a process between; else none. On another node the
//! parent is a daemon.
std::optional<std::string> process_of_mpirun();

//! Returns the words of the command line of mpirun before the program, quoted
//! for the shell; "" if mpirun did not start this process, or on another node,
//! or with a script between.
//! @param program the program as this process was called
std::string launcher_of(const std::string& program);

//! Starts MPI if a launcher has started this process.
//! @throws Error (usage) if the ranks do not find each other.
Session start_session();

//! Lets an action run on all ranks and reports its error. Before an Error of
//! its own, rank 0 tells all ranks to leave. Another rank that fails ends the
//! whole job, since the rest would wait for ever.
ExitCode on_ranks(const Session& session, const Log& log,
                  const std::function<ExitCode()>& action);

//! Lets rank 0 direct the work of the evaluators of all ranks.
//! @throws any exception of the director, once the workers have left.
ExitCode share_work(const Session& session, const Evaluators& evaluators,
                    const StopFlag& stop, const AnswerRules& rules,
                    const std::function<ExitCode(Dispatcher&)>& direct);

}  // namespace ideotype
