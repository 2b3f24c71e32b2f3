// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "ideotype/core/version.hpp"
#include "ideotype/version.hpp"

namespace ideotype {
namespace {

TEST(Version, MacrosAgreeWithTheLibrary) {
    const std::string release = std::to_string(IDEOTYPE_VERSION_MAJOR) + "." +
                                std::to_string(IDEOTYPE_VERSION_MINOR) + "." +
                                std::to_string(IDEOTYPE_VERSION_PATCH);
    // The version of a build between releases ends with its commit.
    const std::string& version = build_info().version;
    EXPECT_EQ(version.substr(0, version.find('+')), release);
}

}  // namespace
}  // namespace ideotype
