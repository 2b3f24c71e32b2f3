// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "beams/beam_lattice.hpp"
#include "ideotype/core/contract.hpp"
#include "tolerance/allocation.hpp"

#ifdef IDEOTYPE_CONTRACTS

namespace ideotype {

TEST(Contracts, OfLightAreChecked) {
    EXPECT_THROW(beam_lattice(0, 1, 9, 1, {0, 0, -1}), ContractError);
    EXPECT_THROW(allocate({}, {}, 0), ContractError);
}

}  // namespace ideotype

#endif
