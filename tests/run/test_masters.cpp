// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include "run/job/masters.hpp"

namespace ideotype {

TEST(Masters, AreAsManyAsWantedIfThereAreRanksAndCases) {
    EXPECT_EQ(masters(2, 9, 3), 2);
    EXPECT_EQ(masters(9, 9, 3), 3);
    EXPECT_EQ(masters(99, 9, 75), 9);
    EXPECT_EQ(masters(9, 1, 75), 1);
    EXPECT_EQ(masters(1, 10'000, 75), 1);
}

TEST(Masters, ServeAThousandRanksEach) {
    EXPECT_EQ(masters({}, 1, 75), 1);
    EXPECT_EQ(masters({}, 1024, 15), 1);
    EXPECT_EQ(masters({}, 4096, 75), 4);
    EXPECT_EQ(masters({}, 10'000, 1), 1);
    EXPECT_EQ(masters({}, 10'000, 75), 10);
}

TEST(Masters, HaveRanksInProportionToTheirCases) {
    constexpr int ranks = 10'000, parts = 38;
    std::vector<double> sizes(parts);
    int last = 0;
    for (int rank = 0; rank < ranks; ++rank) {
        const int part = part_of(rank, ranks, 75, parts);
        EXPECT_TRUE(part == last || part == last + 1) << rank;
        last = part;
        ++sizes.at(static_cast<std::size_t>(part));
    }
    std::size_t next = 0;
    for (int part = 0; part < parts; ++part) {
        const auto [first, count] = dealt(75, part, parts);
        EXPECT_NEAR(sizes[static_cast<std::size_t>(part)],
                    ranks * static_cast<double>(count) / 75, 1);
        EXPECT_LE(count, 2U);
        EXPECT_EQ(first, next);
        next = first + count;
    }
    EXPECT_EQ(next, 75U);
}

TEST(Masters, AdviseOnIdleWorkers) {
    Campaign campaign;
    campaign.search.optimizer = OptimizerKind::automatic;
    campaign.search.population = 40;
    campaign.stop.generations = 400;
    EXPECT_EQ(busy_workers(campaign.search, 3), 30);
    EXPECT_EQ(advice_for(campaign, 1, 10), std::nullopt);
    EXPECT_EQ(advice_for(campaign, 2, 20), std::nullopt);
    EXPECT_EQ(advice_for(campaign, 1, 64),
              "some of the 64 workers are idle at the end of each generation; "
              "64 stay busy with search.streams = 7");
    campaign.search.streams = 7;
    EXPECT_EQ(advice_for(campaign, 1, 64), std::nullopt);
    campaign.stop.evaluations = 3200;
    EXPECT_EQ(advice_for(campaign, 1, 64),
              "each of 7 searches has only 11 generations of 40 plants, and "
              "learns little from fewer than 40; use search.streams = 2, or "
              "more generations");
    campaign.search.streams = 2;
    EXPECT_EQ(
        advice_for(campaign, 1, 64),
        "64 workers are more than this case can keep busy (about 20); use "
        "fewer workers, or more generations and streams");
    campaign.search.streams = 1;
    campaign.search.population = 1024;
    campaign.stop.evaluations = 2500;
    EXPECT_EQ(advice_for(campaign, 1, 8), std::nullopt);
    EXPECT_EQ(advice_for(campaign, 1, 200),
              "2500 evaluations are only 2.44 generations of 1024 plants, and "
              "a search learns little from fewer than 40; use more "
              "evaluations, or search.population = 62 and fewer workers");
    campaign.search.population = 8;
    campaign.stop.evaluations = 24;
    EXPECT_EQ(advice_for(campaign, 1, 9),
              "24 evaluations are only 3 generations of 8 plants, and a search "
              "learns little from fewer than 40; use more evaluations");
    campaign.search.optimizer = OptimizerKind::random;
    EXPECT_EQ(advice_for(campaign, 1, 64), std::nullopt);
}

}  // namespace ideotype
