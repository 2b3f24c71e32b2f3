// SPDX-License-Identifier: Apache-2.0
#include "outcome.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Returns the reason why one of several estimates is unusable, or "".
std::string find_defect(const std::string& name,
                        std::span<const Estimate> values) {
    for (const auto& [mean, standard_error] : values) {
        if (!std::isfinite(mean))
            return name + " is not finite (" + std::to_string(mean) + ")";
        if (!std::isfinite(standard_error))
            return "the standard error of " + name + " is not finite (" +
                   std::to_string(standard_error) + ")";
    }
    return "";
}

std::string find_defect(const OutcomeSchema& schema, const Outcome& outcome) {
    if (outcome.status == Status::failed)
        return outcome.message.empty() ? "no reason given" : outcome.message;
    if (outcome.status != Status::done)
        return "the evaluation returned without a result";
    if (!has_form(schema, outcome))
        return "the evaluation returned other quantities than requested";
    const std::span<const Estimate> quantities(outcome.quantities);
    std::string reason;
    for (std::size_t i = 0; reason.empty() && i < schema.objectives.size(); ++i)
        reason = find_defect("objective " + schema.objectives[i].name,
                             std::span(outcome.objectives).subspan(i, 1));
    std::size_t first = 0;
    for (const Quantity& quantity : schema.measured.quantities) {
        const std::size_t size = schema.measured.size(quantity);
        if (reason.empty())
            reason =
                find_defect(quantity.name, quantities.subspan(first, size));
        first += size;
    }
    if (reason.empty() &&
        !std::all_of(outcome.randomisations.begin(),
                     outcome.randomisations.end(),
                     [](double x) { return std::isfinite(x); }))
        reason = "a randomisation of an objective is not finite";
    if (reason.empty() && !std::isfinite(outcome.violation))
        reason = "the violation of constraints is not finite";
    return reason;
}

}  // namespace

bool has_form(const OutcomeSchema& schema, const Outcome& outcome) {
    const std::size_t objectives = schema.objectives.size();
    return outcome.objectives.size() == objectives &&
           outcome.randomisations.size() ==
               objectives * schema.randomisations &&
           outcome.quantities.size() == schema.measured.size();
}

Outcome unknown_outcome(const OutcomeSchema& schema) {
    Outcome outcome;
    outcome.objectives.resize(schema.objectives.size());
    outcome.randomisations.resize(schema.objectives.size() *
                                  schema.randomisations);
    outcome.quantities.resize(schema.measured.size());
    outcome.for_each_number(
        [](double& x) { x = std::numeric_limits<double>::quiet_NaN(); });
    return outcome;
}

Outcome failed_outcome(const OutcomeSchema& schema, std::string reason) {
    Outcome outcome = unknown_outcome(schema);
    outcome.status = Status::failed;
    outcome.message = std::move(reason);
    return outcome;
}

Outcome checked_outcome(const OutcomeSchema& schema, Outcome outcome) {
    std::string reason = find_defect(schema, outcome);
    if (reason.empty()) return outcome;
    Outcome failed = failed_outcome(schema, std::move(reason));
    failed.seconds = outcome.seconds;
    failed.worker = outcome.worker;
    return failed;
}

Outcome arranged_outcome(Outcome outcome, const OutcomeSchema& own,
                         const OutcomeSchema& other) {
    IDEOTYPE_EXPECT(outcome.quantities.size() == own.measured.size());
    std::vector<Estimate> arranged = unknown_outcome(other).quantities;
    auto next = arranged.begin();
    for (const Quantity& quantity : other.measured.quantities) {
        const std::size_t size = other.measured.size(quantity);
        if (has_same_axes(quantity, other.measured, own.measured))
            std::copy_n(outcome.quantities.begin() +
                            static_cast<std::ptrdiff_t>(
                                own.measured.offset(quantity.name)),
                        size, next);
        next += static_cast<std::ptrdiff_t>(size);
    }
    outcome.quantities = std::move(arranged);
    return outcome;
}

std::optional<Estimate> find(const OutcomeSchema& schema,
                             const Outcome& outcome, const std::string& name) {
    if (!schema.measured.has(name)) return std::nullopt;
    IDEOTYPE_EXPECT(outcome.quantities.size() == schema.measured.size());
    return outcome.quantities[schema.measured.offset(name)];
}

Randomisations select_randomisations(const Outcome& outcome,
                                     std::size_t objective) {
    IDEOTYPE_EXPECT(objective < outcome.objectives.size());
    IDEOTYPE_EXPECT(outcome.randomisations.size() % outcome.objectives.size() ==
                    0);
    const std::size_t count =
        outcome.randomisations.size() / outcome.objectives.size();
    const std::span<const double> values = outcome.randomisations;
    return {outcome.objectives[objective],
            values.subspan(objective * count, count)};
}

Estimate difference(const Outcome& a, const Outcome& b, std::size_t objective) {
    return difference(select_randomisations(a, objective),
                      select_randomisations(b, objective));
}

}  // namespace ideotype
