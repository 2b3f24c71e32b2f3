#include <gtest/gtest.h>

#include "ideotype/cli/wall_time.hpp"

namespace ideotype {
namespace {

TEST(WallTime, ComesInSecondsUnitsOrLikeAClock) {
    EXPECT_EQ(parse_wall_time("90"), 90);
    EXPECT_EQ(parse_wall_time("90s"), 90);
    EXPECT_EQ(parse_wall_time("1m"), 60);
    EXPECT_EQ(parse_wall_time("2h"), 7200);
    EXPECT_EQ(parse_wall_time("1h30m"), 5400);
    EXPECT_EQ(parse_wall_time("1h30m15s"), 5415);
    EXPECT_EQ(parse_wall_time("01:30:15"), 5415);
    EXPECT_EQ(parse_wall_time("100:00:00"), 360000);
}

TEST(WallTime, IsNothingElse) {
    for (const char* text :
         {"", "soon", "0", "0s", "00:00:00", "-5", "1.5h", "30m1h", "1 h",
          "1h:30", "00:99:00", "90sec", "12:00", "9999999999"})
        EXPECT_FALSE(parse_wall_time(text)) << text;
}

}  // namespace
}  // namespace ideotype
