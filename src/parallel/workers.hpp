// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "dispatcher.hpp"
#include "rank_clock.hpp"

namespace ideotype {

//! The outcome sent back by a worker.
struct Answer {
    int worker = 0;
    Outcome outcome;
};

//! Workers, numbered from 0, each of which evaluates one task at a time.
class Workers {
  public:
    virtual ~Workers() = default;

    virtual int width() const = 0;

    //! Returns the number of a worker in the whole job: its thread; with one
    //! thread per rank its MPI rank; with several threads the rank times the
    //! number of threads, plus the thread.
    virtual int number(int worker) const = 0;

    //! Returns the form of the outcome of a task.
    virtual const OutcomeSchema& schema(const Task& task) const = 0;

    //! Gives work to an idle worker, and returns at once.
    virtual void give(int worker, const Work& work) = 0;

    //! Returns the next answer, or nothing after a time [s].
    virtual std::optional<Answer> wait(double seconds) = 0;

    //! Informs all workers that no more work will come.
    virtual void dismiss() = 0;
};

//! Evaluates a genome and sets wall time and worker; any error becomes a failed
//! outcome.
Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank,
                         const RankClock& clock);

//! Makes workers from threads of this process. The destructor waits for all
//! threads: if one may never answer, the caller must end the process instead.
std::unique_ptr<Workers> make_thread_workers(const Session& session,
                                             const Evaluators& evaluators);

//! Makes workers on all ranks except rank 0; if ranks have several threads,
//! also on those of rank 0.
std::unique_ptr<Workers> make_rank_workers(const Session& session,
                                           const Evaluators& evaluators);

}  // namespace ideotype
