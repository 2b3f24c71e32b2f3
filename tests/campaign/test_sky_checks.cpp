// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"

namespace ideotype {

namespace {

//! Returns the sample campaign with one value replaced in the given line.
std::string with(const std::string& line, const std::string& other) {
    return replaced(sample_text(), line, other);
}

std::string warnings_of(const std::string& text) {
    std::string listed;
    for (const Problem& warning : parse_campaign(text, "sample.toml").warnings)
        listed += to_string(warning) + '\n';
    return listed;
}

std::string with_utc_offset(double offset) {
    return with("utc_offset = -5", fmt::format("utc_offset = {}", offset));
}

}  // namespace

TEST(SkyChecks, ADayWithoutLightIsRefused) {
    EXPECT_EQ(problem_of(with("07:00:00\nend = 20", "06:00:00\nend = 07")), "");
    EXPECT_EQ(problem_of(with("07:00:00\nend = 20", "01:00:00\nend = 06")),
              "sample.toml:10:9: day \"0807\" has no light at site \"Ames\" "
              "(the sun is up from 06:19 to 20:20); give a start and an end "
              "within, or a shorter step");
    const std::string polar = with("latitude = 42.0", "latitude = -85");
    EXPECT_EQ(problem_of(polar),
              "sample.toml:9:8: day \"0807\" has no light at site \"Ames\" "
              "(the sun is down all day); take another date or site");
}

TEST(SkyChecks, ClocksFarFromSolarTimeCauseAWarningThenAnError) {
    // At longitude 93.6 deg west, local solar time is UTC - 6.24 h.
    for (const double fine : {-8.2, -6.0, -5.0, -4.3})
        EXPECT_EQ(warnings_of(with_utc_offset(fine)), "") << fine;
    EXPECT_NE(warnings_of(with_utc_offset(-4)).find("2.2 h ahead of the sun's"),
              std::string::npos);
    EXPECT_NE(warnings_of(with_utc_offset(-9)).find("2.8 h behind the sun's"),
              std::string::npos);
    EXPECT_TRUE(
        warnings_of(with_utc_offset(-4)).starts_with("sample.toml:7:14: site"));
    EXPECT_EQ(problem_of(with_utc_offset(-2.3)), "");
    EXPECT_NE(problem_of(with_utc_offset(-2.2)).find("check the signs"),
              std::string::npos);
    EXPECT_NE(problem_of(with_utc_offset(-10.3)).find("4.1 h behind"),
              std::string::npos);
}

TEST(SkyChecks, SpacingsInOtherUnitsCauseAWarning) {
    EXPECT_EQ(warnings_of(with("row = 0.762", "row = 2")), "");
    EXPECT_EQ(warnings_of(with("row = 0.762", "row = 7.5")),
              "sample.toml:13:7: spacing.row is 7.5 m (crops stand closer; 7.5 "
              "inches are 0.1905 m, 7.5 feet 2.286 m); give metres\n");
    EXPECT_NE(warnings_of(with("plant = 0.1524", "plant = 6"))
                  .find("spacing.plant is 6 m"),
              std::string::npos);
}

TEST(SkyChecks, StandsWithTooManyLeavesCauseAWarning) {
    const auto warnings = [](const std::string& row) {
        return read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml",
                             {"spacing.row=" + row})
            .warnings;
    };
    EXPECT_TRUE(warnings("0.33").empty());
    ASSERT_EQ(warnings("0.2").size(), 1u);
    EXPECT_EQ(warnings("0.2").front().what,
              "spacing.row is 0.2 m (with 0.1524 m between plants the baseline "
              "has a leaf area index of 13.10, and fields hardly ever have "
              "more than 8); check both distances");
}

TEST(SkyChecks, CampaignsOfTheProjectCauseNoWarning) {
    int campaigns = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(IDEOTYPE_CAMPAIGNS))
        if (entry.path().extension() == ".toml") {
            ++campaigns;
            // The densest spacings of a campaign exceed those of real fields
            // on purpose, and one hybrid does not mature at all five latitudes
            // of another.
            const bool is_dense = entry.path().stem() == "spacings";
            const bool is_late = entry.path().stem() == "maize_belt";
            for (const Problem& warning :
                 read_campaign(entry.path().string()).warnings)
                EXPECT_TRUE((is_dense && warning.what.find("leaf area index") !=
                                             std::string::npos) ||
                            (is_late && warning.what.find("not mature") !=
                                            std::string::npos))
                    << to_string(warning);
        }
    EXPECT_GE(campaigns, 8);
}

//! 16 plants of one leaf have 768 pieces. With 72 paths in each of 16
//! randomisations there are 1.5 paths per piece.
TEST(Light, TooFewPathsForAssimilationCauseAWarning) {
    const auto warnings = [](const std::string& objective, int paths,
                             const std::string& more = "") {
        return warnings_of(sample_text(
            "", fmt::format("[photosynthesis]\namax = 50\n[objective]\n"
                            "maximise = \"{}\"\n[light]\n"
                            "paths = {}\n{}",
                            objective, paths, more)));
    };
    EXPECT_THAT(warnings("net_assimilation", 71),
                testing::HasSubstr("too few for this objective"));
    EXPECT_THAT(warnings("net_assimilation", 71),
                testing::HasSubstr("use 72 or more"));
    EXPECT_EQ(warnings("net_assimilation", 72), "");
    EXPECT_EQ(warnings("absorbed_par", 16), "");
    // Each of several fields requires this number of paths.
    EXPECT_THAT(warnings("carbon_balance", 72, "fields = 4\n"),
                testing::HasSubstr("use 288 or more"));
}

}  // namespace ideotype
