// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "ideotype/core/error.hpp"
#include "parallel/dispatcher.hpp"
#include "parallel/session.hpp"
#include "run/log.hpp"

namespace ideotype {

//! The most threads that `--threads` starts.
inline constexpr int most_threads = 4096;

//! Reads how many threads "3" or "auto" stands for.
//! @throws Error of wrong usage.
int parse_threads(const std::string& text);

//! The place of this process among those that an MPI launcher, such as mpirun
//! or srun, has started.
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

//! Lets an action run on all ranks and reports its error. Rank 0 tells the
//! others to leave before an Error of its own; ranks would wait for ever for
//! one that fails by itself, which therefore ends all.
ExitCode on_ranks(const Session& session, const Log& log,
                  const std::function<ExitCode()>& action);

//! Lets rank 0 direct the work of the evaluators of all ranks.
//! @throws whatever directing throws, once the workers have gone.
ExitCode share_work(const Session& session, const Evaluators& evaluators,
                    const StopFlag& stop, const AnswerRules& rules,
                    const std::function<ExitCode(Dispatcher&)>& direct);

}  // namespace ideotype
