// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/light/device.hpp"
#include "two_leaves.hpp"

#ifdef IDEOTYPE_CONTRACTS

namespace ideotype {

TEST(Contracts, OfCanopiesAreChecked) {
    CanopyRequest request = two_leaves({64, 4});
    request.layers.count = 0;
    const Device device(Device::supported_isas().back());
    EXPECT_THROW(evaluate(request, device), ContractError);
    EXPECT_THROW(cell_of({0, 2, {.76, .15}}), ContractError);
}

}  // namespace ideotype

#endif
