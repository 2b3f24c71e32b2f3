// SPDX-License-Identifier: Apache-2.0
// Contracts are checked in this file, whatever the build options.
#ifndef IDEOTYPE_CONTRACTS
#define IDEOTYPE_CONTRACTS
#endif
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Contract, ValidConditionHasNoEffect) {
    int evaluations = 0;
    IDEOTYPE_EXPECT(++evaluations == 1);
    IDEOTYPE_ENSURE(++evaluations == 2);
    EXPECT_EQ(evaluations, 2);
}

TEST(Contract, ViolationIsReportedWithItsLocation) {
    const int sum = 3;
    const int line = __LINE__ + 1;
    EXPECT_THAT([&] { IDEOTYPE_EXPECT(sum == 4); },
                ThrowsMessage<ContractError>(AllOf(
                    HasSubstr("test_contract.cpp:" + std::to_string(line) +
                              ": a precondition"),
                    HasSubstr("does not hold: sum == 4"))));
    EXPECT_THAT([&] { IDEOTYPE_ENSURE(sum == 4); },
                ThrowsMessage<ContractError>(HasSubstr("a promise")));
}

TEST(Contract, ConditionMayContainCommas) {
    const auto sum = [](int a, int b) { return a + b; };
    EXPECT_THROW(IDEOTYPE_EXPECT(sum(1, 2) == sum(2, 2)), ContractError);
}

TEST(Contract, ViolationIsNotAnErrorOfTheUser) {
    try {
        IDEOTYPE_EXPECT(false);
        FAIL();
    } catch (const Error&) {
        FAIL();
    } catch (const std::logic_error&) {
    }
}

void never_throw(bool holds) noexcept {
    IDEOTYPE_EXPECT(holds);
}

TEST(ContractDeathTest,
     ViolationInNoexceptFunctionEndsTheProgramWithItsMessage) {
    never_throw(true);
    EXPECT_DEATH(never_throw(false), "does not hold: holds");
}

}  // namespace ideotype
