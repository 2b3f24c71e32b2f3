// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/contract.hpp"
#include "search/cma_es/dd_cma.hpp"
#include "search/sobol_sequence.hpp"
#include "search/summary.hpp"

#ifdef IDEOTYPE_CONTRACTS

namespace ideotype {

TEST(Contracts, PreconditionsOfSearchesAreChecked) {
    using Eigen::VectorXd;
    EXPECT_THROW(DdCma(VectorXd::Zero(2), VectorXd::Ones(2), 3), ContractError);
    EXPECT_THROW(SobolSequence(1, 2).at(0, 2), ContractError);
    EXPECT_THROW(Summarizer({}, {}, {}), ContractError);
}

}  // namespace ideotype

#endif
