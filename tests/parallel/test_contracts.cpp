// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fake_workers.hpp"
#include "ideotype/core/contract.hpp"

#ifdef IDEOTYPE_CONTRACTS

namespace ideotype {

TEST(Contracts, PreconditionsOfWorkersAreChecked) {
    FakeEvaluator evaluator;
    const Session session = Session::alone();
    EXPECT_THROW(make_thread_workers(session, {}), ContractError);
    EXPECT_THROW(make_thread_workers(session, {&evaluator})->give(1, {}),
                 ContractError);
    EXPECT_THROW(session.split(-1), ContractError);
}

}  // namespace ideotype

#endif
