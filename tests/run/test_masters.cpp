// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include "run/masters.hpp"

namespace ideotype {

TEST(Masters, AreAsManyAsWantedIfThereAreRanksAndCases) {
    EXPECT_EQ(masters(2, 9, 3), 2);
    EXPECT_EQ(masters(9, 9, 3), 3);
    EXPECT_EQ(masters(99, 9, 75), 9);
    EXPECT_EQ(masters(9, 1, 75), 1);
    EXPECT_EQ(masters(1, 10'000, 75), 1);
}

TEST(Masters, OfLargeJobsHaveAnEvenNumberOfCases) {
    EXPECT_EQ(masters({}, 1, 75), 1);
    EXPECT_EQ(masters({}, 511, 75), 1);
    EXPECT_EQ(masters({}, 1024, 1), 1);
    EXPECT_EQ(masters({}, 1024, 15), 4);
    EXPECT_EQ(masters({}, 4096, 75), 19);
    EXPECT_EQ(masters({}, 10'000, 1), 1);
    EXPECT_EQ(masters({}, 10'000, 15), 15);
    EXPECT_EQ(masters({}, 10'000, 75), 38);
}

TEST(Masters, HaveRanksInProportionToTheirCases) {
    std::vector<Case> all(75);
    for (int i = 0; i < 75; ++i) all[static_cast<std::size_t>(i)].index = i;
    constexpr int ranks = 10'000, parts = 38;
    std::vector<double> sizes(parts);
    int last = 0;
    for (int rank = 0; rank < ranks; ++rank) {
        const int part = part_of(rank, ranks, 75, parts);
        EXPECT_TRUE(part == last || part == last + 1) << rank;
        last = part;
        ++sizes.at(static_cast<std::size_t>(part));
    }
    std::vector<int> found;
    for (int part = 0; part < parts; ++part) {
        const auto own = dealt(all, part, parts);
        const auto count = static_cast<double>(own.size());
        EXPECT_NEAR(sizes[static_cast<std::size_t>(part)], ranks * count / 75,
                    1);
        EXPECT_LE(own.size(), 2U);
        for (const Case& each : own) found.push_back(each.index);
    }
    for (int i = 0; i < 75; ++i)
        EXPECT_EQ(found.at(static_cast<std::size_t>(i)), i);
}

}  // namespace ideotype
