// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include "ideotype/core/text.hpp"
#include "run/progress.hpp"
#include "run/summary.hpp"

namespace ideotype {
namespace {

TEST(Format, PrintsHalfOfTheConfidenceIntervalWithTwoDigits) {
    EXPECT_EQ(format({11.12345, 0.0234}), "11.123 ± 0.046");
    EXPECT_EQ(format({1234.5, 67}), "1234 ± 131");
    EXPECT_EQ(format({3, 0}), "3");
    EXPECT_EQ(format({3.5, std::numeric_limits<double>::quiet_NaN()}), "3.5");
    EXPECT_EQ(format({std::numeric_limits<double>::quiet_NaN(), 1}), "unknown");
}

TEST(Format, ZerosAndSmallNumbersHaveFewDigits) {
    EXPECT_EQ(format({0, 0}), "0");
    EXPECT_EQ(format({-0., 0}), "0");
    EXPECT_EQ(format({3e-16, 0}), "0");
    EXPECT_EQ(format({-2e-15, 4e-15}), "0");
    EXPECT_EQ(format({0.40173143865, 3e-17}), "0.401731439");
    EXPECT_EQ(format({-7.7e-7, 7.6e-7}), "-7.7e-07 ± 1.5e-06");
    EXPECT_EQ(format({2.5e-5, 0}), "2.5e-05");
    EXPECT_EQ(format({-1e-9, 0.0023}), "0.0000 ± 0.0045");
    EXPECT_EQ(format({0, 0.5}), "0.00 ± 0.98");
    EXPECT_EQ(format({0.85613542, 7.7e-7}), "0.8561354 ± 0.0000015");
}

TEST(Format, DurationsReadLikeAClock) {
    EXPECT_EQ(format_duration(3.2), "0:03");
    EXPECT_EQ(format_duration(125), "2:05");
    EXPECT_EQ(format_duration(3725), "1:02:05");
}

const std::vector<std::string> clauses{"12 of 40 cases done",
                                       "time left 0:37",
                                       "best 10.35 ± 0.12 MJ m-2 day-1",
                                       "10 of 30 plants",
                                       "28.8 evaluations per second",
                                       "lat0_0807_300x140_all_r1"};

TEST(LineWithBar, NeverIsWiderThanTheTerminal) {
    for (std::size_t width = 1; width < 250; ++width) {
        const std::string line = line_with_bar(0.5, clauses, width);
        EXPECT_LE(count_columns(line), width);
        EXPECT_EQ(line[0] == '[', width >= 31) << line;
    }
}

TEST(LineWithBar, OmitsLessImportantPartsAndCutsNone) {
    EXPECT_EQ(
        line_with_bar(0.5, clauses, 79),
        "[####.....] 12 of 40 cases done, time left 0:37, best 10.35 ± 0.12 "
        "MJ m-2 day-1");
    const std::string wide = line_with_bar(0.5, clauses, 200);
    for (const std::string& part : clauses)
        EXPECT_NE(wide.find(part), std::string::npos) << part;
}

TEST(LineWithBar, FillsTheBarInProportionToProgress) {
    EXPECT_EQ(line_with_bar(0, {"x"}, 14), "[..........] x");
    EXPECT_EQ(line_with_bar(0.25, {"x"}, 14), "[##........] x");
    EXPECT_EQ(line_with_bar(1, {"x"}, 14), "[##########] x");
    EXPECT_EQ(line_with_bar(7, {"x"}, 14), "[##########] x");
}

}  // namespace
}  // namespace ideotype
