// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "run/job/way_on.hpp"

namespace ideotype {
namespace {

TEST(WayOn, IsQuotedForTheShell) {
    EXPECT_EQ(quoted({"run", "a/b-1.toml", "--out=x"}),
              "run a/b-1.toml --out=x");
    EXPECT_EQ(quoted({"my run", "", "it's", "$x", "a*"}),
              "'my run' '' 'it'\\''s' '$x' 'a*'");
}

TEST(WayOn, ResumesAsTheRunWasStarted) {
    EXPECT_EQ(way_on("ideotype run a.toml", 1), "ideotype run a.toml --resume");
    EXPECT_EQ(way_on("ideotype run a.toml", 4),
              "mpirun -n 4 ideotype run a.toml --resume");
    EXPECT_EQ(way_on("ideotype run a.toml --resume", 4),
              "mpirun -n 4 ideotype run a.toml --resume");
    EXPECT_EQ(way_on("ideotype run a.toml", 4, "mpirun --oversubscribe -n 4"),
              "mpirun --oversubscribe -n 4 ideotype run a.toml --resume");
    EXPECT_EQ(way_on("ideotype run a.toml", 1, "mpirun -n 1"),
              "ideotype run a.toml --resume");
    // This path contains the name of the option.
    EXPECT_EQ(way_on("ideotype run a--resume.toml", 2),
              "mpirun -n 2 ideotype run a--resume.toml --resume");
}

TEST(WayOn, RecognisesAStartOfThisProgram) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"/a b/ideotype", "run", "it's $x.toml"},
          {"ideotype", "sensitivity", "a.toml"}})
        EXPECT_TRUE(is_start(quoted(words))) << quoted(words);
    for (const char* foreign :
         {"", "ideotype run x.toml; curl evil|sh", "ideotype run $(evil)",
          "ideotype run 'x", "ideotype run x\\", "ideotype run 'x\x1b[1A'",
          "ideotype run x\nevil", "evil run x.toml", "ideotype status x",
          "ideotype run  x"})
        EXPECT_FALSE(is_start(foreign)) << foreign;
}

}  // namespace
}  // namespace ideotype
