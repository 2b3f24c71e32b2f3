// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/quantity.hpp"

namespace ideotype {

//! Identifies an evaluation by slot, generation and case. Generation and slot
//! also select the random numbers, so an evaluation is a pure function of its
//! task and genome. Outside a run, a task may request another seed and another
//! accuracy.
struct Task {
    std::uint32_t case_index = 0;
    std::uint32_t generation = 0;
    std::uint32_t slot = 0;
    std::uint32_t attempt = 1;
    //! Whether this is a final evaluation, with independent random numbers and
    //! higher accuracy.
    bool is_final = false;
    std::optional<std::uint64_t> seed{};  //!< replaces the campaign's seed
    //! Relative standard error of the light absorbed by leaves, at most 0.05,
    //! which is to be reached with as few paths as possible.
    std::optional<double> tolerance{};

    bool operator==(const Task&) const = default;
};

//! The state of an evaluation. Its numbers are stored in files.
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

//! An objective of the search. Its sign is not changed for minimisation; it may
//! be negative.
struct Objective {
    std::string name;
    std::string unit;
    Sense sense = Sense::maximise;
};

//! The numbers that each outcome in a table of rows contains.
struct OutcomeSchema {
    std::vector<Objective> objectives;
    //! The number of independent randomisations, over which objectives are
    //! averaged.
    std::size_t randomisations = 2;
    QuantitySet measured;
};

//! The result of one evaluation.
struct Outcome {
    Status status = Status::failed;
    std::vector<Estimate> objectives;
    //! Values of each objective by randomisation [objective, randomisation].
    //! Plants with common random numbers have paired randomisations, which give
    //! the paired standard error of their difference.
    std::vector<double> randomisations;
    //! The violation of constraints relative to their limits; 0 if all
    //! constraints are met.
    double violation = 0;
    std::vector<Estimate> quantities;  //!< in the order of the schema
    double seconds = 0;                //!< wall time on the worker [s]
    std::string message;               //!< the reason of a failure
    std::uint32_t worker = 0;          //!< number of the worker that evaluated

    //! Calls a function with each number of the outcome, in a fixed order.
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

//! Returns an outcome with the numbers of a schema, all of them NaN.
Outcome unknown_outcome(const OutcomeSchema& schema);

//! Returns a failed outcome, in which all numbers are NaN.
Outcome failed_outcome(const OutcomeSchema& schema, std::string reason);

//! Returns the outcome. If any number in it is missing or not finite, returns a
//! failed outcome instead; its reason names the quantity.
Outcome checked_outcome(const OutcomeSchema& schema, Outcome outcome);

//! Returns an outcome with the quantities of another schema. Those that its own
//! schema lacks, or has along other axes, are NaN.
Outcome arranged_outcome(Outcome outcome, const OutcomeSchema& own,
                         const OutcomeSchema& other);

//! Returns a quantity that consists of a single number, or nothing if it is
//! missing.
std::optional<Estimate> find(const OutcomeSchema& schema,
                             const Outcome& outcome, const std::string& name);

//! Returns an objective with its values by randomisation.
Randomisations select_randomisations(const Outcome& outcome,
                                     std::size_t objective = 0);

//! Returns the difference b - a of an objective, with its paired standard error
//! over shared randomisations. If these are unknown, the outcomes are treated
//! as independent, which can only overestimate the error.
Estimate difference(const Outcome& a, const Outcome& b,
                    std::size_t objective = 0);

}  // namespace ideotype
