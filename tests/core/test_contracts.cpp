// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/clock.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/hash.hpp"

#ifdef IDEOTYPE_CONTRACTS

namespace ideotype {

TEST(Contracts, PreconditionsOfCoreAreChecked) {
    EXPECT_THROW(clock_time(48), ContractError);
    Sha256 sum;
    sum.finish();
    EXPECT_THROW(sum.finish(), ContractError);
}

}  // namespace ideotype

#endif
