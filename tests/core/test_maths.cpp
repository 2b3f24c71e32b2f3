// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "ideotype/core/host.hpp"

namespace ideotype {
namespace {

TEST(Maths, FingerprintHas16HexadecimalDigits) {
    const std::string& text = maths_fingerprint();
    EXPECT_EQ(text.size(), 16U);
    for (const char c : text) EXPECT_TRUE(std::isxdigit(c)) << text;
}

}  // namespace
}  // namespace ideotype
