// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/contract.hpp"
#include "stand/across_scenarios.hpp"
#include "stand/stand.hpp"

#ifdef IDEOTYPE_CONTRACTS

namespace ideotype {

TEST(Contracts, AreCheckedInStands) {
    const Campaign campaign =
        read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml");
    EXPECT_THROW(lai_of_line({}, 0), ContractError);
    EXPECT_THROW(AcrossScenarios(campaign, cases(campaign).front()).combine({}),
                 ContractError);
}

}  // namespace ideotype

#endif
