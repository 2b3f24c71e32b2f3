// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <limits>
#include <new>
#include <thread>

#include "ideotype/core/error.hpp"
#include "ideotype/core/random.hpp"
#include "parallel/dispatcher.hpp"

namespace ideotype {

inline OutcomeSchema fake_schema() {
    OutcomeSchema schema;
    schema.objectives = {{"light", "MJ m-2"}, {"yield", "g"}};
    schema.measured.quantities = {
        {"area", "m2", ""}, {"height", "m", ""}, {"reflected", "1", ""}};
    return schema;
}

//! A fast evaluator, a pure function of task and genome, which fails in some
//! slots.
class FakeEvaluator : public Evaluator {
  public:
    static constexpr std::uint32_t throwing_slot = 1001;
    static constexpr std::uint32_t oddly_throwing_slot = 1002;
    static constexpr std::uint32_t not_a_number_slot = 1003;

    //! The slot in which the machine fails, not the plant.
    static constexpr std::uint32_t starved_slot = 1006;

    //! Slots with slow evaluations: only at the first attempt, or at every
    //! attempt.
    static constexpr std::uint32_t slow_once_slot = 1004;
    static constexpr std::uint32_t slow_slot = 1005;

    explicit FakeEvaluator(std::chrono::milliseconds duration = {},
                           std::chrono::milliseconds long_duration = {})
        : duration_(duration), long_duration_(long_duration) {}

    const OutcomeSchema& schema(const Task&) const override { return schema_; }

    Outcome evaluate(const Task& task, const Genome& genome) override {
        const bool is_slow = task.slot == slow_slot ||
                             (task.slot == slow_once_slot && task.attempt == 1);
        std::this_thread::sleep_for(is_slow ? long_duration_ : duration_);
        if (task.slot == throwing_slot)
            throw Error("leaf 3 is longer than the row");
        if (task.slot == oddly_throwing_slot) throw 42;
        if (task.slot == starved_slot) throw std::bad_alloc();

        RandomStream random(task.case_index,
                            task.is_final ? Purpose::scramble : Purpose::jitter,
                            task.generation, task.slot);
        double sum = random.uniform();
        for (const double gene : genome) sum += gene * random.uniform();
        Outcome outcome;
        outcome.status = Status::done;
        outcome.objectives = {{sum, 0.1 * sum}, {1 / sum, random.uniform()}};
        outcome.randomisations = {sum, sum, 1 / sum, random.uniform()};
        outcome.violation = random.uniform();
        outcome.quantities = {{random.uniform(), 0}, {-sum, 1}, {0, 1e-300}};
        if (task.slot == not_a_number_slot)
            outcome.quantities[1].mean =
                std::numeric_limits<double>::quiet_NaN();
        return outcome;
    }

  private:
    std::chrono::milliseconds duration_;
    std::chrono::milliseconds long_duration_;
    OutcomeSchema schema_ = fake_schema();
};

}  // namespace ideotype
