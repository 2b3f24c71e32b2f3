// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "dispatcher.hpp"
#include "rank_clock.hpp"

namespace ideotype {

//! The outcome that a worker returns.
struct Answer {
    int worker = 0;
    Outcome outcome;
};

//! Workers, numbered from 0, each of which evaluates one task at a time.
class Workers {
  public:
    virtual ~Workers() = default;

    virtual int width() const = 0;

    //! Returns the number of a worker in the whole job. In a single process it
    //! is the thread; with one thread per rank, the MPI rank; with several, the
    //! rank times the number of threads, plus the thread.
    virtual int number(int worker) const = 0;

    //! Returns the schema of the outcome of a task.
    virtual const OutcomeSchema& schema(const Task& task) const = 0;

    //! Gives work to an idle worker, and returns at once.
    virtual void give(int worker, const Work& work) = 0;

    //! Returns the next answer, or nothing if none arrives within a number of
    //! seconds.
    virtual std::optional<Answer> wait(double seconds) = 0;

    //! Informs all workers that there is no more work.
    virtual void dismiss() = 0;
};

//! Evaluates a genome, and sets the wall time and the worker of the outcome.
//! Any error becomes a failed outcome.
Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank,
                         const RankClock& clock);

//! Makes workers from threads of this process. The destructor waits for all
//! threads; if one of them might never answer, the caller must end the process.
std::unique_ptr<Workers> make_thread_workers(const Session& session,
                                             const Evaluators& evaluators);

//! Makes workers on all ranks except rank 0. If ranks have several threads, the
//! threads of rank 0 are workers too.
std::unique_ptr<Workers> make_rank_workers(const Session& session,
                                           const Evaluators& evaluators);

}  // namespace ideotype
