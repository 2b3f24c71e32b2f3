// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include "ideotype/run/progress.hpp"
#include "ideotype/run/summary.hpp"

namespace ideotype {
namespace {

TEST(Format, ShowsTwoDigitsOfTheStandardError) {
    EXPECT_EQ(format({11.12345, 0.0234}), "11.123 +- 0.023");
    EXPECT_EQ(format({1234.5, 67}), "1234 +- 67");
    EXPECT_EQ(format({3, 0}), "3");
    EXPECT_EQ(format({3.5, std::numeric_limits<double>::quiet_NaN()}), "3.5");
    EXPECT_EQ(format({std::numeric_limits<double>::quiet_NaN(), 1}), "unknown");
}

TEST(Format, DurationsReadLikeAClock) {
    EXPECT_EQ(format_duration(3.2), "0:03");
    EXPECT_EQ(format_duration(125), "2:05");
    EXPECT_EQ(format_duration(3725), "1:02:05");
}

TEST(Format, DailyEnergyComesInThreeUnits) {
    EXPECT_EQ(format_daily({10, 0.5}),
              "10.00 +- 0.50 MJ m-2 day-1 = 45.7 +- 2.3 mol m-2 day-1 = "
              "11.24 +- 0.56 MWh acre-1 day-1");
}

}  // namespace
}  // namespace ideotype
