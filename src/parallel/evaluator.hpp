// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "search/outcome.hpp"
#include "search/population.hpp"

namespace ideotype {

//! Computes outcomes on a worker.
class Evaluator {
  public:
    virtual ~Evaluator() = default;

    //! Returns the schema of the outcome of a task.
    virtual const OutcomeSchema& schema(const Task& task) const = 0;

    //! Evaluates a genome. The outcome is a pure function of task and genome,
    //! except for `seconds`.
    //! @throws Error if the plant cannot be evaluated; the worker converts it
    //! to a failed outcome. Any other exception, such as a lack of memory, is a
    //! failure of the machine and ends the job.
    virtual Outcome evaluate(const Task& task, const Genome& genome) = 0;
};

//! The evaluators of a process, one for each of its threads.
using Evaluators = std::vector<Evaluator*>;

}  // namespace ideotype
