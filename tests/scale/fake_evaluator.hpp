// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "ideotype/core/random.hpp"
#include "parallel/evaluator.hpp"
#include "simulated_clock.hpp"

namespace ideotype {

//! Advances the simulated time by the duration of an evaluation, and returns an
//! outcome with all columns. All ranks of a simulation share one evaluator.
class FakeEvaluator : public Evaluator {
  public:
    //! @param seconds mean duration of an evaluation; durations are distributed
    //! as measured, see README.md
    FakeEvaluator(OutcomeSchema schema, double seconds)
        : schema_(std::move(schema)), seconds_(seconds) {}

    const OutcomeSchema& schema(const Task&) const override { return schema_; }

    Outcome evaluate(const Task& task, const Genome& genome) override {
        const double seconds = seconds_of(task);
        SimulatedClock::spend(seconds);
        if (!task.is_final) total_ += seconds;
        Outcome outcome = unknown_outcome(schema_);
        outcome.for_each_number([](double& x) { x = 1; });
        outcome.status = Status::done;
        outcome.objectives.assign(schema_.objectives.size(), {genome[0], 0.1});
        return outcome;
    }

    //! Returns the total duration of all evaluations so far [s].
    double total() const { return total_; }

  private:
    //! Returns the duration of one evaluation, a function of the task [s].
    double seconds_of(const Task& task) const {
        // Measured durations of evaluations of campaigns/ames.toml, relative to
        // their mean, at equal steps of probability.
        constexpr double quantiles[] = {
            0.223, 0.276, 0.332, 0.512, 0.623, 0.664, 0.709,
            0.752, 0.826, 0.94,  1.01,  1.04,  1.07,  1.1,
            1.14,  1.18,  1.31,  1.43,  1.55,  1.83,  3.19};
        constexpr int steps = static_cast<int>(std::size(quantiles)) - 1;
        RandomStream random(task.case_index, Purpose::jitter, task.generation,
                            task.slot);
        const double at = random.uniform(0, steps);
        const int below = static_cast<int>(at);
        return seconds_ *
               std::lerp(quantiles[below], quantiles[below + 1], at - below);
    }

    OutcomeSchema schema_;
    double seconds_;
    double total_ = 0;
};

}  // namespace ideotype
