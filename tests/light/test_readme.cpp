// SPDX-License-Identifier: Apache-2.0
// README.md is written by light_report; these tests notice a stale one.
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "extremes.hpp"
#include "reference_cases.hpp"

namespace ideotype {
namespace {

std::string readme() {
    std::ifstream stream(IDEOTYPE_LIGHT_README);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(Readme, HasEveryReferenceValueAndNoOther) {
    const std::string text = readme();
    std::size_t values = 0;
    for (const ReferenceScene& scene : reference_scenes())
        for (const ReferenceCase& one : scene.cases)
            for (const KnownValue& known : one.known) {
                ++values;
                const std::string row =
                    "| " + one.name + " | " + known.quantity + " |";
                EXPECT_NE(text.find(row), std::string::npos) << row;
            }
    const auto cases = count_cases(reference_scenes());
    const std::string count = "**" + std::to_string(cases) + " cases, " +
                              std::to_string(values) + " values**";
    EXPECT_NE(text.find(count), std::string::npos) << count;
}

TEST(Readme, HasEveryExtreme) {
    const std::string text = readme();
    for (const ExtremeCase& extreme : extreme_cases()) {
        const std::string row =
            "| " + extreme.name + " | " + extreme.expectation + " |";
        EXPECT_NE(text.find(row), std::string::npos) << row;
    }
    const std::string count =
        "**" + std::to_string(extreme_cases().size()) + " cases**";
    EXPECT_NE(text.find(count), std::string::npos) << count;
}

}  // namespace
}  // namespace ideotype
