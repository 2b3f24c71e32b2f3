// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "ideotype/core/random.hpp"
#include "parallel/evaluator.hpp"
#include "simulated_clock.hpp"

namespace ideotype {

//! Lets the simulated time of an evaluation pass and returns all columns of a
//! real outcome. All ranks of a simulation share one evaluator.
class FakeEvaluator : public Evaluator {
  public:
    //! @param seconds mean time of an evaluation; times spread around it as
    //! measured, see README.md
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

    //! Returns the time of all evaluations so far [s].
    double total() const { return total_; }

  private:
    //! Returns the time of one evaluation, a function of the task [s].
    double seconds_of(const Task& task) const {
        // The times of evaluations of campaigns/ames.toml, in equal steps of
        // probability, relative to their mean.
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
