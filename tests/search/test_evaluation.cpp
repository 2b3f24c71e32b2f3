#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "ideotype/search/evaluation.hpp"

namespace ideotype {
namespace {

const OutcomeSchema schema{{{"absorbed_par", "MJ m-2 day-1"}},
                           {{"lai", "m2 m-2"}}};

Outcome good() {
    Outcome outcome;
    outcome.status = Status::done;
    outcome.objectives = {{9, 0.1}};
    outcome.diagnostics = {{3, 0}};
    return outcome;
}

TEST(Evaluation, AFiniteOutcomePassesUnchanged) {
    const Outcome checked = checked_outcome(schema, good());
    EXPECT_EQ(checked.status, Status::done);
    EXPECT_EQ(checked.objectives[0].mean, 9);
}

TEST(Evaluation, NumbersThatAreNotFiniteBecomeAFailureWithItsReason) {
    Outcome outcome = good();
    outcome.diagnostics[0].mean = std::numeric_limits<double>::infinity();
    const Outcome checked = checked_outcome(schema, outcome);
    EXPECT_EQ(checked.status, Status::failed);
    EXPECT_NE(checked.message.find("lai"), std::string::npos);
    EXPECT_TRUE(std::isnan(checked.objectives[0].mean));

    outcome = good();
    outcome.objectives[0].standard_error = std::nan("");
    EXPECT_EQ(checked_outcome(schema, outcome).status, Status::failed);
}

TEST(Evaluation, MissingColumnsAreAFailure) {
    Outcome outcome = good();
    outcome.diagnostics.clear();
    EXPECT_EQ(checked_outcome(schema, outcome).status, Status::failed);
}

}  // namespace
}  // namespace ideotype
