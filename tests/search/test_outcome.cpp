// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "search/outcome.hpp"

namespace ideotype {
namespace {

const OutcomeSchema schema{{{"absorbed_par", "MJ m-2 day-1"}},
                           3,
                           {{}, {{"lai", "m2 m-2", "leaf area"}}}};

Outcome make_good() {
    Outcome outcome;
    outcome.status = Status::done;
    outcome.objectives = {{9, 0.1}};
    outcome.randomisations = {8.8, 9, 9.2};
    outcome.quantities = {{3, 0}};
    return outcome;
}

TEST(Outcome, FiniteOutcomePassesUnchanged) {
    const Outcome checked = checked_outcome(schema, make_good());
    EXPECT_EQ(checked.status, Status::done);
    EXPECT_EQ(checked.objectives[0].mean, 9);
}

TEST(Outcome, NonFiniteNumbersBecomeAFailureWithReason) {
    Outcome outcome = make_good();
    outcome.quantities[0].mean = std::numeric_limits<double>::infinity();
    const Outcome checked = checked_outcome(schema, outcome);
    EXPECT_EQ(checked.status, Status::failed);
    EXPECT_NE(checked.message.find("lai"), std::string::npos);
    EXPECT_TRUE(std::isnan(checked.objectives[0].mean));

    outcome = make_good();
    outcome.objectives[0].standard_error = std::nan("");
    EXPECT_EQ(checked_outcome(schema, outcome).status, Status::failed);
}

TEST(Outcome, MissingColumnsAreAFailure) {
    Outcome outcome = make_good();
    outcome.quantities.clear();
    EXPECT_EQ(checked_outcome(schema, outcome).status, Status::failed);
}

TEST(Outcome, MissingRandomisationsAreAFailure) {
    Outcome outcome = make_good();
    outcome.randomisations.pop_back();
    EXPECT_EQ(checked_outcome(schema, outcome).status, Status::failed);
}

TEST(Outcome, SharedRandomNumbersCancelInADifference) {
    Outcome other = make_good();
    other.objectives[0].mean += 1;
    for (double& x : other.randomisations) x += 1;
    EXPECT_NEAR(difference(make_good(), other).mean, 1, 1e-12);
    EXPECT_NEAR(difference(make_good(), other).standard_error, 0, 1e-12);
    other.randomisations = {10.2, 10, 9.8};
    EXPECT_NEAR(difference(make_good(), other).standard_error,
                .4 / std::sqrt(3), 1e-12);
    // If randomisations are unknown, errors are treated as independent.
    other.randomisations.front() = std::nan("");
    EXPECT_NEAR(difference(make_good(), other).standard_error,
                .1 * std::sqrt(2), 1e-12);
}

TEST(Outcome, DifferencesArePairedWithAnyNumberOfObjectives) {
    Outcome more = make_good();
    more.objectives.push_back({1, 0.5});
    for (const double x : {1., 2., 3.}) more.randomisations.push_back(x);
    EXPECT_EQ(difference(make_good(), more).standard_error, 0);
    EXPECT_EQ(difference(more, more, 1).standard_error, 0);
    more.randomisations.pop_back();
    more.randomisations.pop_back();  // two for each objective
    EXPECT_NEAR(difference(make_good(), more).standard_error, .1 * std::sqrt(2),
                1e-12);
}

}  // namespace
}  // namespace ideotype
