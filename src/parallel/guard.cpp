// SPDX-License-Identifier: Apache-2.0
#include "guard.hpp"

#include <exception>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"

namespace ideotype {

namespace {

//! Leaves the row as it was proposed, for a machine that can.
Outcome not_evaluated(const std::string& reason) {
    Outcome outcome;
    outcome.status = Status::proposed;
    outcome.message = fmt::format("on {}: {}", host_name(), reason);
    return outcome;
}

Outcome caught_outcome(Evaluator& evaluator, const Work& work,
                       const OutcomeSchema& schema) {
    try {
        return checked_outcome(schema,
                               evaluator.evaluate(work.task, work.genome));
    } catch (const Error& error) {
        return failed_outcome(schema, error.what());
    } catch (const std::exception& error) {
        return not_evaluated(reason_of(error));
    } catch (...) {
        return not_evaluated("an exception of unknown type");
    }
}

}  // namespace

Outcome evaluate_guarded(Evaluator& evaluator, const Work& work, int rank,
                         const RankClock& clock) {
    const OutcomeSchema& schema = evaluator.schema(work.task);
    const double start = clock.now();
    Outcome outcome = caught_outcome(evaluator, work, schema);
    outcome.seconds = clock.now() - start;
    outcome.worker = static_cast<std::uint32_t>(rank);
    return outcome;
}

}  // namespace ideotype
