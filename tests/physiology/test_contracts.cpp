// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/physiology/leaf_exchange.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

#ifdef IDEOTYPE_CONTRACTS

namespace ideotype {

TEST(Contracts, OfLeavesAreChecked) {
    EXPECT_THROW(scaled(HyperbolaLeaf{}, -1), ContractError);
    LeafSurroundings no_blade;
    no_blade.width = 0;
    EXPECT_THROW(energy_balance({}, no_blade), ContractError);
}

}  // namespace ideotype

#endif
