// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/quantity.hpp"

namespace ideotype {

//! The identity of an evaluation: slot, generation and case. Generation and
//! slot also select the random numbers, so an evaluation is a pure function of
//! its task and genome. Outside of a run a task may request another seed and
//! another accuracy.
struct Task {
    std::uint32_t case_index = 0;
    std::uint32_t generation = 0;
    std::uint32_t slot = 0;
    std::uint32_t attempt = 1;
    //! Whether it is a final evaluation, with new random numbers and higher
    //! accuracy.
    bool is_final = false;
    std::optional<std::uint64_t> seed{};  //!< replaces the campaign's seed
    //! Relative standard error of the leaves' light, at most 0.05, to be
    //! reached with as few paths as possible.
    std::optional<double> tolerance{};

    bool operator==(const Task&) const = default;
};

//! The state of an evaluation. The numbers are part of the file format.
enum class Status : std::uint8_t {
    empty = 0,     //!< no genome yet
    proposed = 1,  //!< genome written, not evaluated
    done = 2,
    failed = 3,
};

//! Returns whether a row with this status has an outcome.
inline bool is_recorded(Status status) {
    return status == Status::done || status == Status::failed;
}

//! The direction in which an objective improves.
enum class Sense { maximise, minimise };

//! An objective of the search, in its natural sign; it may be negative.
struct Objective {
    std::string name;
    std::string unit;
    Sense sense = Sense::maximise;
};

//! The form of the outcomes of all rows of a table.
struct OutcomeSchema {
    std::vector<Objective> objectives;
    //! The number of independent randomisations; objectives are their means.
    std::size_t randomisations = 2;
    QuantitySet measured;
};

//! The result of one evaluation.
struct Outcome {
    Status status = Status::failed;
    std::vector<Estimate> objectives;
    //! Each objective by randomisation [objective, randomisation]. Plants that
    //! share random numbers have paired randomisations, from which the paired
    //! standard error of their difference follows.
    std::vector<double> randomisations;
    //! The violation of constraints relative to their limits; 0 if all are met.
    double violation = 0;
    std::vector<Estimate> quantities;  //!< in the order of the schema
    double seconds = 0;                //!< wall time on the worker [s]
    std::string message;               //!< the reason of a failure
    std::uint32_t worker = 0;          //!< number of the worker that evaluated

    //! Calls an action with each number of the outcome, in a fixed order.
    template <class Action>
    void for_each_number(Action action) {
        const auto visit = [&](std::vector<Estimate>& estimates) {
            for (Estimate& x : estimates) {
                action(x.mean);
                action(x.standard_error);
            }
        };
        visit(objectives);
        for (double& x : randomisations) action(x);
        action(violation);
        visit(quantities);
    }
};

//! Returns whether an outcome has as many numbers as its schema requires.
bool has_form(const OutcomeSchema& schema, const Outcome& outcome);

//! Returns an outcome of a schema, with NaN for all numbers.
Outcome unknown_outcome(const OutcomeSchema& schema);

//! Returns a failed outcome with NaN for all numbers.
Outcome failed_outcome(const OutcomeSchema& schema, std::string reason);

//! Returns the outcome; if any number in it is missing or not finite, returns a
//! failed outcome with a reason that names the quantity.
Outcome checked_outcome(const OutcomeSchema& schema, Outcome outcome);

//! Returns a quantity that is a single number, or nothing if it is missing.
std::optional<Estimate> find(const OutcomeSchema& schema,
                             const Outcome& outcome, const std::string& name);

//! Returns an objective with its values by randomisation.
Randomisations select_randomisations(const Outcome& outcome,
                                     std::size_t objective = 0);

//! Returns the difference of an objective, b less a, with its paired standard
//! error over shared randomisations. If these are unknown, the error is that of
//! independent outcomes, which can only be too large.
Estimate difference(const Outcome& a, const Outcome& b,
                    std::size_t objective = 0);

}  // namespace ideotype
