// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! A mistake of a caller, and the condition that notices the mistake.
struct Mistake {
    std::string condition;
    std::function<void()> make;
};

//! Expects that the condition of each mistake notices it, in builds that check
//! contracts.
inline void expect_noticed(const std::vector<Mistake>& mistakes) {
#ifndef IDEOTYPE_CONTRACTS
    GTEST_SKIP() << "this build does not look at contracts";
#endif
    for (const auto& [condition, make] : mistakes) {
        SCOPED_TRACE(condition);
        try {
            make();
            ADD_FAILURE() << "nobody noticed";
        } catch (const ContractError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(
                                          "does not hold: " + condition + ";"));
        }
    }
}

}  // namespace ideotype
