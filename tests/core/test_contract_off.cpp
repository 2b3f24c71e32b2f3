// SPDX-License-Identifier: Apache-2.0
// Contracts are not checked in this file, whatever the build says.
#undef IDEOTYPE_CONTRACTS
#include <gtest/gtest.h>

#include "ideotype/core/contract.hpp"

namespace ideotype {

TEST(ContractOff, IsNotEvaluated) {
    int looked = 0;
    IDEOTYPE_EXPECT(++looked > 0);
    IDEOTYPE_ENSURE(++looked > 0);
    EXPECT_EQ(looked, 0);
}

TEST(ContractOff, MayNotHold) {
    EXPECT_NO_THROW(IDEOTYPE_EXPECT(false));
    EXPECT_NO_THROW(IDEOTYPE_ENSURE(1 + 1 == 3));
}

// A contract is an expression that a constant function may have.
constexpr int half(int n) {
    IDEOTYPE_EXPECT(n % 2 == 0);
    return n / 2;
}
static_assert(half(4) == 2);

}  // namespace ideotype
