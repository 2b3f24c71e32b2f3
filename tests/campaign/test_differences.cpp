// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "sample_campaign.hpp"
#include "spec/reader.hpp"

namespace ideotype {

namespace {

using Lines = std::vector<std::string>;

//! Returns the differences that affect the first case.
Lines changes(const std::string& was, const std::string& is) {
    const Campaign campaign = sample();
    return differences(read_resolved(was), read_resolved(is),
                       cases(campaign).front());
}

}  // namespace

TEST(Differences, AreEmptyForEqualCampaigns) {
    EXPECT_EQ(changes(sample().resolved, sample().resolved), Lines{});
}

TEST(Differences, ChangedKeysHaveDottedNames) {
    const std::string was = sample().resolved;
    const std::string is =
        sample("seed = 2\n", "[light]\nrandomisations = 32\n").resolved;
    EXPECT_EQ(changes(was, is), (Lines{"seed was 1, is 2",
                                       "light.randomisations was 16, is 32"}));
}

TEST(Differences, EntriesOfListsAreCountedFromZero) {
    const std::string was = sample().resolved;
    std::string is = was;
    is.replace(is.find("latitude = 42"), 13, "latitude = 43");
    is.replace(is.find("curvature = 60"), 14, "curvature = 61");
    EXPECT_EQ(changes(was, is),
              (Lines{"site.latitude was 42, is 43",
                     "plant.baseline.leaf[0].curvature was 60, is 61"}));
}

TEST(Differences, AddedAndRemovedEntriesAreAbsentOnOneSide) {
    const std::string was = sample().resolved;
    const std::string is =
        sample("",
               "[[plant.baseline.organ]]\nname = \"ear\"\nlength = 0.2\n"
               "base_diameter = 0.05\n")
            .resolved;
    const Lines lines = changes(was, is);
    EXPECT_EQ(std::count(lines.begin(), lines.end(),
                         "plant.baseline.organ[0].length was absent, is 0.2"),
              1);
    EXPECT_EQ(changes(is, was)[1],
              "plant.baseline.organ[0].name was \"ear\", is absent");
}

TEST(Differences, IgnoreEntriesOfOtherCases) {
    const std::string site =
        "[[site]]\nname = \"Boone\"\nlatitude = 43.0\nlongitude = -93.6\n"
        "utc_offset = -5\n";
    const std::string more =
        "[[spacing]]\nrow = 0.381\nplant = 0.1524\n"
        "[[day]]\ndate = 2025-07-07\nstart = 07:00:00\nend = 20:00:00\n"
        "[[traits]]\nname = \"angles\"\nfree = [\"insertion_angle\"]\n";
    const std::string text =
        "[[traits]]\nname = \"all\"\nfree = [\"length\", \"width\", "
        "\"insertion_angle\", \"azimuth\"]\n";
    const std::string was = sample().resolved;
    // The new entries precede and follow the old ones.
    const std::string before =
        sample("replicates = 3\n" + site, more + text).resolved;
    const std::string behind = sample("", text + more + site).resolved;
    for (const std::string& is : {before, behind}) {
        EXPECT_EQ(changes(was, is), Lines{});
        EXPECT_EQ(changes(is, was), Lines{});
        EXPECT_EQ(changes(was, replaced(is, "latitude = 42", "latitude = 4")),
                  Lines{"site.latitude was 42, is 4"});
        EXPECT_EQ(changes(was, replaced(is, "randomisations = 16",
                                        "randomisations = 32")),
                  Lines{"light.randomisations was 16, is 32"});
    }
}

TEST(Differences, AllEntriesOfAnAxisOfScenariosArePartOfACase) {
    const std::string over = "[objective]\nover = \"spacing\"\n";
    const std::string spacing = "[[spacing]]\nrow = 0.381\nplant = 0.1524\n";
    const Campaign was = sample("", over);
    const Campaign is = sample("", spacing + over);
    const Lines lines = differences(was.spec, is.spec, cases(is).front());
    EXPECT_NE(std::find(lines.begin(), lines.end(),
                        "spacing[1].row was absent, is 0.381"),
              lines.end());
    EXPECT_EQ(differences(is.spec, is.spec, cases(is).front()), Lines{});
}

}  // namespace ideotype
