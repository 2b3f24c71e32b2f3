#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/search/genome.hpp"

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

//! How far an evaluation has come. The numbers are part of the file format.
enum class Status : std::uint8_t {
    empty = 0,     //!< no genome yet
    proposed = 1,  //!< genome written, not evaluated
    done = 2,
    failed = 3,
};

//! Where a genome came from. The numbers are part of the file format.
enum class Origin : std::uint8_t {
    none = 0,
    baseline = 1,
    random = 2,
    elite = 3,  //!< a parent evaluated again under new random numbers
    child = 4,
};

//! Which values of an objective are better.
enum class Sense { maximise, minimise };

//! A column of an outcome.
struct Quantity {
    std::string name;
    std::string unit;
};

//! What an evaluation returns, in order; the same for all rows of a history.
struct OutcomeSchema {
    std::vector<Quantity> objectives;
    std::vector<Quantity> diagnostics;
};

//! The result of one evaluation.
struct Outcome {
    Status status = Status::failed;
    std::vector<Estimate> objectives;
    std::vector<Estimate> diagnostics;
    double seconds = 0;        //!< wall time on the worker
    std::string message;       //!< the reason of a failure
    std::uint32_t worker = 0;  //!< rank that evaluated
};

//! A failed outcome with NaN in all columns of the schema.
Outcome failed_outcome(const OutcomeSchema& schema, std::string reason);

//! A copy that is failed, with a reason that names the column, if any number
//! in it is not finite or missing. A failed outcome gets NaN in all columns.
Outcome checked_outcome(const OutcomeSchema& schema, Outcome outcome);

//! Computes outcomes; lives on a worker.
class Evaluator {
  public:
    virtual ~Evaluator() = default;

    //! The columns of this task's outcome.
    virtual const OutcomeSchema& schema(const Task& task) const = 0;

    //! A pure function of task and genome, but for seconds.
    //! @throws any exception; the worker turns it into a failed outcome.
    virtual Outcome evaluate(const Task& task, const Genome& genome) = 0;
};

}  // namespace ideotype
