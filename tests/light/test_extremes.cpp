// SPDX-License-Identifier: Apache-2.0
// Tests extreme but valid input.
#include <gtest/gtest.h>

#include "expectations.hpp"

namespace ideotype {

void PrintTo(const ExtremeCase& extreme, std::ostream* out) {
    *out << extreme.name;
}

namespace {

class Extreme : public ::testing::TestWithParam<ExtremeCase> {};

TEST_P(Extreme, IsAsExpected) {
    Findings findings;
    GetParam().run(findings);
    for (const std::string& failure : findings.failures())
        ADD_FAILURE() << failure;
    RecordProperty("balance_error", std::to_string(findings.balance_error()));
    RecordProperty("result", findings.result());
}

INSTANTIATE_TEST_SUITE_P(All, Extreme, ::testing::ValuesIn(extreme_cases()),
                         [](const auto& test) {
                             return test_name(test.param.name);
                         });

}  // namespace
}  // namespace ideotype
