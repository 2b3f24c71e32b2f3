#include "ideotype/search/evaluation.hpp"

#include <cmath>
#include <limits>

namespace ideotype {

namespace {

//! What is wrong with some columns of an outcome, or "".
std::string defect(const std::vector<Quantity>& columns,
                   const std::vector<Estimate>& values,
                   const std::string& kind) {
    if (values.size() != columns.size())
        return "the evaluation returned " + std::to_string(values.size()) +
               " " + kind + "s instead of " + std::to_string(columns.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto& [mean, standard_error] = values[i];
        const std::string name = kind + " \"" + columns[i].name + "\"";
        if (!std::isfinite(mean))
            return name + " is not finite (" + std::to_string(mean) + ")";
        if (!std::isfinite(standard_error))
            return "the standard error of " + name + " is not finite (" +
                   std::to_string(standard_error) + ")";
    }
    return {};
}

std::string defect(const OutcomeSchema& schema, const Outcome& outcome) {
    if (outcome.status == Status::failed)
        return outcome.message.empty() ? "no reason given" : outcome.message;
    if (outcome.status != Status::done)
        return "the evaluation returned without a result";
    const std::string objective =
        defect(schema.objectives, outcome.objectives, "objective");
    return objective.empty()
               ? defect(schema.diagnostics, outcome.diagnostics, "diagnostic")
               : objective;
}

}  // namespace

Outcome failed_outcome(const OutcomeSchema& schema, std::string reason) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Outcome outcome;
    outcome.status = Status::failed;
    outcome.objectives.assign(schema.objectives.size(), {nan, nan});
    outcome.diagnostics.assign(schema.diagnostics.size(), {nan, nan});
    outcome.message = std::move(reason);
    return outcome;
}

Outcome checked_outcome(const OutcomeSchema& schema, Outcome outcome) {
    std::string reason = defect(schema, outcome);
    if (reason.empty()) return outcome;
    Outcome failed = failed_outcome(schema, std::move(reason));
    failed.seconds = outcome.seconds;
    failed.worker = outcome.worker;
    return failed;
}

}  // namespace ideotype
