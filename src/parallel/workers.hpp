// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "dispatcher.hpp"
#include "rank_clock.hpp"

namespace ideotype {

//! The outcome that a worker sent back.
struct Answer {
    int worker = 0;
    Outcome outcome;
};

//! A number of workers, counted from 0, that evaluate one task at a time each.
class Workers {
  public:
    virtual ~Workers() = default;

    virtual int width() const = 0;

    //! Returns the number of a worker in the whole job: its thread; with one
    //! thread per rank its MPI rank; with several the rank times their number,
    //! plus the thread.
    virtual int number(int worker) const = 0;

    //! Returns the form of the outcome of a task.
    virtual const OutcomeSchema& schema(const Task& task) const = 0;

    //! Gives work to a worker that has none. Returns at once.
    virtual void give(int worker, const Work& work) = 0;

    //! Returns the next answer, or none after this time [s].
    virtual std::optional<Answer> wait(double seconds) = 0;

    //! Tells all workers that there will be no more work.
    virtual void dismiss() = 0;
};

//! Evaluates; whatever goes wrong becomes a failed outcome. Fills in the wall
//! time and the worker.
Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank,
                         const RankClock& clock);

//! Makes workers of threads of this process. Their end is awaited: who is not
//! sure that all answer must end the process instead.
std::unique_ptr<Workers> make_thread_workers(const Session& session,
                                             const Evaluators& evaluators);

//! Makes workers of all ranks but rank 0, and if each has several threads of
//! those of rank 0 too.
std::unique_ptr<Workers> make_rank_workers(const Session& session,
                                           const Evaluators& evaluators);

}  // namespace ideotype
