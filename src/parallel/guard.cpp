// SPDX-License-Identifier: Apache-2.0
#include "guard.hpp"

#include <exception>

namespace ideotype {

namespace {

Outcome caught_outcome(Evaluator& evaluator, const Work& work,
                       const OutcomeSchema& schema) {
    try {
        return evaluator.evaluate(work.task, work.genome);
    } catch (const std::exception& error) {
        return failed_outcome(schema, error.what());
    } catch (...) {
        return failed_outcome(schema, "an exception of unknown type");
    }
}

}  // namespace

Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank,
                         const RankClock& clock) {
    const OutcomeSchema& schema = evaluator.schema(work.task);
    const double start = clock.now();
    Outcome outcome =
        checked_outcome(schema, caught_outcome(evaluator, work, schema));
    outcome.seconds = clock.now() - start;
    outcome.worker = static_cast<std::uint32_t>(rank);
    return outcome;
}

}  // namespace ideotype
