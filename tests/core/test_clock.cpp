// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/clock.hpp"

namespace ideotype {
namespace {

TEST(Duration, SecondsUnitsAndClockFormatsAreParsed) {
    EXPECT_EQ(parse_duration("90"), 90);
    EXPECT_EQ(parse_duration("90s"), 90);
    EXPECT_EQ(parse_duration("1m"), 60);
    EXPECT_EQ(parse_duration("2h"), 7200);
    EXPECT_EQ(parse_duration("1h30m"), 5400);
    EXPECT_EQ(parse_duration("1h30m15s"), 5415);
    EXPECT_EQ(parse_duration("01:30:15"), 5415);
    EXPECT_EQ(parse_duration("100:00:00"), 360000);
    EXPECT_EQ(parse_duration("0"), 0);
    EXPECT_EQ(parse_duration("00:00:00"), 0);
}

TEST(Duration, OtherTextsAreRejected) {
    for (const char* text : {"", "soon", "-5", "1.5h", "30m1h", "1 h", "1h:30",
                             "00:99:00", "90sec", "12:00", "9999999999"})
        EXPECT_FALSE(parse_duration(text)) << text;
    EXPECT_FALSE(parse_duration(std::string(1 << 20, '1')));
}

TEST(ClockName, NameShowsTheOffsetFromUtc) {
    EXPECT_EQ(clock_name(0), "UTC");
    EXPECT_EQ(clock_name(2), "UTC+2");
    EXPECT_EQ(clock_name(-5), "UTC-5");
    EXPECT_EQ(clock_name(5.5), "UTC+5:30");
    EXPECT_EQ(clock_name(-3.5), "UTC-3:30");
}

TEST(ClockTime, TimeIsWithinOneDay) {
    EXPECT_EQ(clock_time(0), "00:00");
    EXPECT_EQ(clock_time(13.33), "13:20");
    EXPECT_EQ(clock_time(-0.5), "23:30");
    EXPECT_EQ(clock_time(24.25), "00:15");
    EXPECT_EQ(clock_time(23.9999), "00:00");
}

}  // namespace
}  // namespace ideotype
