// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/contract.hpp"
#include "sample_history.hpp"

#ifdef IDEOTYPE_CONTRACTS

namespace ideotype {

TEST(Contracts, PreconditionsOfHistoriesAreChecked) {
    const Folder folder;
    HistoryHeader header = sample_header();
    History history = History::create(folder / "case.h5", header);
    EXPECT_THROW(history.set_wall_time(-1), ContractError);
    header.population = 0;
    EXPECT_THROW(History::create(folder / "other.h5", header), ContractError);
}

}  // namespace ideotype

#endif
