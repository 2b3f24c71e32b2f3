#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "ideotype/core/stop_flag.hpp"
#include "ideotype/evolve/evaluation.hpp"
#include "ideotype/parallel/session.hpp"

namespace ideotype {

//! A task and the genome to evaluate.
struct Work {
    Task task;
    Genome genome;

    bool operator==(const Work&) const = default;
};

//! Called on rank 0 for each outcome as it arrives; must make it durable
//! before it returns.
using Record = std::function<void(const Work&, const Outcome&)>;

//! Hands work to evaluators on demand and gathers what they return.
class Dispatcher {
  public:
    virtual ~Dispatcher() = default;

    //! Evaluates all work, in any order. If a stop is requested, hands out
    //! nothing more, waits for what is in flight, and returns. An exception
    //! of record passes through; what was in flight is then lost.
    virtual void evaluate(const std::vector<Work>& work,
                          const Record& record) = 0;

    //! How many evaluations can run at the same time.
    virtual int width() const = 0;
};

//! With one rank: evaluates here, one after the other.
//! With more: rank 0 sends work to idle workers and sleeps in between; its
//! destruction tells the workers to leave serve(). All references must
//! outlive the dispatcher. With more ranks, rank 0 asks the evaluator for its
//! schema only.
std::unique_ptr<Dispatcher> make_dispatcher(const Session& session,
                                            Evaluator& evaluator,
                                            const StopFlag& stop);

//! The life of a worker rank: receives work, evaluates, replies, until rank 0
//! says that there is no more. An exception in an evaluation becomes a failed
//! outcome with its message, cut to 160 bytes.
//! @throws Error if a message arrives that is neither.
void serve(const Session& session, Evaluator& evaluator);

}  // namespace ideotype
