// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "dispatcher.hpp"
#include "rank_clock.hpp"

namespace ideotype {

//! What a worker sent back.
struct Answer {
    int worker = 0;
    Outcome outcome;
};

//! Those who evaluate: workers counted from 0, each with one task at a time.
class Workers {
  public:
    virtual ~Workers() = default;

    virtual int width() const = 0;

    //! The number of a worker in the whole job: its thread; with one thread
    //! per rank its MPI rank; with several the rank times their number, plus
    //! the thread.
    virtual int number(int worker) const = 0;

    //! The columns of this task's outcome.
    virtual const OutcomeSchema& schema(const Task& task) const = 0;

    //! Gives work to a worker that has none. Returns at once.
    virtual void give(int worker, const Work& work) = 0;

    //! The next answer, or none after this time [s].
    virtual std::optional<Answer> wait(double seconds) = 0;

    //! Tells all workers that there will be no more work.
    virtual void dismiss() = 0;
};

//! Evaluates; whatever goes wrong becomes a failed outcome. Fills in the wall
//! time and the worker.
Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank,
                         const RankClock& clock);

//! Threads of this process. Their end is awaited: who is not sure that all
//! answer must end the process instead.
std::unique_ptr<Workers> make_thread_workers(const Session& session,
                                             const Evaluators& evaluators);

//! All ranks but rank 0, and if each has several threads those of rank 0.
std::unique_ptr<Workers> make_rank_workers(const Session& session,
                                           const Evaluators& evaluators);

}  // namespace ideotype
