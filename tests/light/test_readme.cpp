// SPDX-License-Identifier: Apache-2.0
// light_report writes README.md and reference_values.md; these tests fail if
// the files are out of date.
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "extremes.hpp"
#include "reference_cases.hpp"

namespace ideotype {
namespace {

std::string read_page(const std::string& name) {
    std::ifstream stream(IDEOTYPE_LIGHT_PAGES + name);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(Readme, HasEveryReferenceValueAndNoOther) {
    const std::string text = read_page("reference_values.md");
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
    EXPECT_NE(read_page("README.md").find(count), std::string::npos) << count;
    // The header of the table and its separator line begin with the same
    // character as rows.
    std::size_t rows = 0;
    for (std::size_t at = text.find("\n|"); at != std::string::npos;
         at = text.find("\n|", at + 1))
        ++rows;
    EXPECT_EQ(rows, values + 2);
}

TEST(Readme, HasEveryExtreme) {
    const std::string text = read_page("README.md");
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
