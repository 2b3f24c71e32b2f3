#pragma once

#include <cstdint>

#include "ideotype/search/genome.hpp"
#include "ideotype/search/outcome.hpp"

namespace ideotype {

//! Which evaluation is meant: slot of a generation of a case. Generation and
//! slot also select the random numbers, so that an evaluation is a pure
//! function of its task and genome.
struct Task {
    std::uint32_t case_index = 0;
    std::uint32_t generation = 0;
    std::uint32_t slot = 0;
    std::uint32_t attempt = 1;
    //! Final evaluations use fresh random numbers and higher accuracy.
    bool is_final = false;

    bool operator==(const Task&) const = default;
};

//! Computes outcomes; lives on a worker.
class Evaluator {
  public:
    virtual ~Evaluator() = default;

    //! The form of this task's outcome.
    virtual const OutcomeSchema& schema(const Task& task) const = 0;

    //! A pure function of task and genome, but for seconds.
    //! @throws any exception; the worker turns it into a failed outcome.
    virtual Outcome evaluate(const Task& task, const Genome& genome) = 0;
};

}  // namespace ideotype
