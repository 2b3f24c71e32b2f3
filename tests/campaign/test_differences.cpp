// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sample_campaign.hpp"

namespace ideotype {

namespace {

using Lines = std::vector<std::string>;

}  // namespace

TEST(Differences, EqualCampaignsHaveNone) {
    EXPECT_EQ(differences(sample().resolved, sample().resolved), Lines{});
}

TEST(Differences, ChangedKeysHaveDottedNames) {
    const std::string was = sample().resolved;
    const std::string is =
        sample("seed = 2\n", "[light]\nrandomisations = 32\n").resolved;
    EXPECT_EQ(
        differences(was, is),
        (Lines{"seed was 1, is 2", "light.randomisations was 16, is 32"}));
}

TEST(Differences, EntriesOfAxesAreCountedFromZero) {
    const std::string was = sample().resolved;
    std::string is = was;
    is.replace(is.find("latitude = 42"), 13, "latitude = 43");
    is.replace(is.find("curvature = 60"), 14, "curvature = 61");
    EXPECT_EQ(differences(was, is),
              (Lines{"site[0].latitude was 42, is 43",
                     "plant.baseline.leaf[0].curvature was 60, is 61"}));
}

TEST(Differences, AddedAndRemovedEntriesAreAbsentOnOneSide) {
    const std::string was = sample().resolved;
    const std::string is =
        sample("", "[[spacing]]\nrow = 0.381\nplant = 0.1524\n").resolved;
    EXPECT_EQ(differences(was, is),
              (Lines{"spacing[1].name was absent, is \"381x152\"",
                     "spacing[1].row was absent, is 0.381",
                     "spacing[1].plant was absent, is 0.1524",
                     "spacing[1].row_direction was absent, is 90"}));
    EXPECT_EQ(differences(is, was)[1], "spacing[1].row was 0.381, is absent");
}

}  // namespace ideotype
