// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/run/way_on.hpp"

namespace ideotype {
namespace {

TEST(WayOn, IsQuotedForTheShell) {
    EXPECT_EQ(quoted({"run", "a/b-1.toml", "--out=x"}),
              "run a/b-1.toml --out=x");
    EXPECT_EQ(quoted({"my run", "", "it's", "$x", "a*"}),
              "'my run' '' 'it'\\''s' '$x' 'a*'");
}

TEST(WayOn, StartsAsTheRunWasStarted) {
    EXPECT_EQ(way_on("ideotype run a.toml", 1), "ideotype run a.toml --resume");
    EXPECT_EQ(way_on("ideotype run a.toml", 4),
              "mpirun -n 4 ideotype run a.toml --resume");
    EXPECT_EQ(way_on("ideotype run a.toml --resume", 4),
              "mpirun -n 4 ideotype run a.toml --resume");
    for (const char* ranks : {"--ranks auto", "--ranks=4"})
        EXPECT_EQ(way_on("ideotype run a.toml " + std::string(ranks), 4),
                  "ideotype run a.toml " + std::string(ranks) + " --resume");
    // Paths that only look like options.
    EXPECT_EQ(way_on("ideotype run a--resume.toml --out x--ranks", 2),
              "mpirun -n 2 ideotype run a--resume.toml --out x--ranks "
              "--resume");
}

}  // namespace
}  // namespace ideotype
