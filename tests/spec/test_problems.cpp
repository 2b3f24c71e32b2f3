// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "spec/problems.hpp"

namespace ideotype {

namespace {

//! Returns the problems of a spacing table with two values.
Problems spacing() {
    const Problems problems = Problems().in("spacing", 1);
    problems.locate("row", {"a.toml", 4, 7});
    problems.locate("plant", {"a.toml", 5, 9});
    return problems;
}

std::vector<Problem> reported(const Problems& problems) {
    try {
        problems.throw_if_any();
    } catch (const InputError& error) {
        return error.problems();
    }
    return {};
}

}  // namespace

TEST(Problems, RulesReportTheirFirstKey) {
    const Problems problems = spacing();
    problems.rule({"row", "plant"}, false, "is fine");
    problems.rule(
        {"plant", "row"}, [] { return true; }, "is {}", "wide");
    const std::vector<Problem> listed = reported(problems);
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_EQ(to_string(listed[0]), "a.toml:5:9: is wide");
    EXPECT_EQ(listed[0].key, "spacing.plant");
    EXPECT_EQ(listed[0].code, ProblemCode::contradiction);
}

TEST(Problems, RulesOfExcludedKeysAreNotEvaluated) {
    const Problems problems = spacing();
    problems.rule(ProblemCode::duplicate, {"row"}, true, "was given");
    const auto fail = []() -> bool { throw Error("evaluated"); };
    const auto fault = []() -> std::string { throw Error("evaluated"); };
    problems.rule({"plant", "row"}, fail, "of a spoilt key");
    problems.rule({"plant", "row"}, fault);
    problems.rule({"plant", "absent"}, fail, "of a key without a place");
    problems.doubt({"plant", "row"}, fail, "of a spoilt key");
    const std::vector<Problem> listed = reported(problems);
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_EQ(listed[0].code, ProblemCode::duplicate);
    EXPECT_TRUE(problems.usable({"plant"}));
    EXPECT_TRUE(problems.warnings().empty());
}

TEST(Problems, RulesByAFunctionHaveItsText) {
    const Problems problems = spacing();
    problems.rule({"row"}, [] { return std::string(); });
    EXPECT_TRUE(problems.empty());
    problems.rule({"row"}, [] { return std::string("is {}"); });
    EXPECT_EQ(reported(problems)[0].what, "is {}");
}

TEST(Problems, DoubtsLeaveValuesUsable) {
    const Problems problems = spacing();
    problems.doubt({"row"}, true, "is {} m", 3);
    problems.doubt({"row"}, false, "is fine");
    EXPECT_TRUE(problems.empty());
    EXPECT_TRUE(problems.usable({"row"}));
    const std::vector<Problem> warnings = problems.warnings();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].what, "is 3 m");
    EXPECT_EQ(warnings[0].key, "spacing.row");
    EXPECT_EQ(warnings[0].code, ProblemCode::doubt);
}

TEST(Problems, EveryCodeHasAName) {
    for (int code = 0; code <= static_cast<int>(ProblemCode::doubt); ++code)
        EXPECT_STRNE(name_of(static_cast<ProblemCode>(code)), "") << code;
}

}  // namespace ideotype
