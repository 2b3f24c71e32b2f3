// SPDX-License-Identifier: Apache-2.0
// Contracts are not checked in this file, whatever the build options.
#undef IDEOTYPE_CONTRACTS
#include <gtest/gtest.h>

#include "ideotype/core/contract.hpp"

namespace ideotype {

TEST(ContractOff, ConditionIsNotEvaluated) {
    int evaluations = 0;
    IDEOTYPE_EXPECT(++evaluations > 0);
    IDEOTYPE_ENSURE(++evaluations > 0);
    EXPECT_EQ(evaluations, 0);
}

TEST(ContractOff, ConditionMayBeFalse) {
    EXPECT_NO_THROW(IDEOTYPE_EXPECT(false));
    EXPECT_NO_THROW(IDEOTYPE_ENSURE(1 + 1 == 3));
}

// Contracts may be used in constant expressions.
constexpr int half(int n) {
    IDEOTYPE_EXPECT(n % 2 == 0);
    return n / 2;
}
static_assert(half(4) == 2);

}  // namespace ideotype
