// SPDX-License-Identifier: Apache-2.0
// Campaigns with plants that respond to density.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"

namespace ideotype {
namespace {

constexpr auto responses = R"([plant.baseline.plasticity]
reference = 6
turning = [4, 9]
turn = 0.5
[[plant.baseline.response]]
scales = ["leaf.width"]
slope = -0.2
densities = [3, 12]
[[plant.baseline.response]]
shifts = ["leaf.insertion_angle"]
slope = [-2, -4, -6]
)";

constexpr double density = 1 / (0.762 * 0.1524);

Leaf first_leaf(const Campaign& campaign) {
    const Case chosen = cases(campaign).at(0);
    return at_density(campaign, chosen, 0, campaign.crop.baseline).leaves.at(0);
}

//! Returns the warnings of the sample campaign with plants that respond.
std::string warnings(const std::string& text) {
    std::string all;
    for (const Problem& each : parse_campaign(text, "sample.toml").warnings)
        all += each.what + '\n';
    return all;
}

TEST(Plasticity, PlantsOfACaseHaveRespondedToItsDensity) {
    const Campaign campaign = sample("", responses);
    const Leaf leaf = first_leaf(campaign);
    EXPECT_DOUBLE_EQ(leaf.width, .08 * std::pow(density / 6, -.2));
    EXPECT_DOUBLE_EQ(leaf.insertion_angle, 40 - 2 * std::log(density / 6));
    EXPECT_EQ(campaign.crop.baseline.leaves[0].width, .08)
        << "genomes describe plants at the reference density";
}

TEST(Plasticity, ACampaignMayTurnItOff) {
    const Campaign campaign = sample("", responses),
                   off = parse_campaign(
                       replaced(sample_text("", responses), "[plant]\n",
                                "[plant]\nplasticity = false\n"),
                       "sample.toml");
    EXPECT_NE(first_leaf(campaign).width, .08);
    EXPECT_EQ(first_leaf(off).width, .08);
    EXPECT_EQ(first_leaf(off).insertion_angle, 40);
    EXPECT_EQ(off.crop.baseline.plasticity.turn, 0);
    EXPECT_NE(off.resolved.find("plasticity = false"), std::string::npos);
}

TEST(Plasticity, IsWrittenAsItIsRead) {
    const Campaign campaign = sample("", responses);
    const std::string text = crop_text(campaign, campaign.crop.baseline);
    for (const char* line :
         {"reference = 6", "turn = 0.5", "slope = -0.2", "densities = [3, 12]"})
        EXPECT_NE(text.find(line), std::string::npos) << line << " in " << text;
    const Campaign again = parse_campaign(campaign.resolved, "again.toml");
    EXPECT_EQ(again.resolved, campaign.resolved);
    EXPECT_EQ(first_leaf(again).width, first_leaf(campaign).width);
    // Leaves may turn without a reference density.
    const Campaign turning = sample("", R"([plant.baseline.plasticity]
turning = [4, 9]
turn = 0.5
)");
    EXPECT_NE(turning.resolved.find("turn = 0.5"), std::string::npos);
    EXPECT_EQ(parse_campaign(turning.resolved, "again.toml").resolved,
              turning.resolved);
    // Crops without plasticity are written as before.
    const Campaign rigid = sample();
    EXPECT_EQ(rigid.resolved.find("plasticity"), std::string::npos);
    EXPECT_EQ(rigid.resolved.find("over_density"), std::string::npos);
}

TEST(Plasticity, OfPlantsAtUnknownDensitiesIsAWarning) {
    const std::string text = sample_text("", responses);
    EXPECT_EQ(warnings(text).find("plants m-2"), std::string::npos);
    EXPECT_NE(
        warnings(replaced(text, "plant = 0.1524", "plant = 0.06"))
            .find("responses of single to density are known from 3 to 12"),
        std::string::npos);
}

TEST(Plasticity, HighPlantsOfADenseStandAreWithinTheLayers) {
    const Campaign rigid = sample(), campaign = sample("", R"(
[plant.baseline.plasticity]
reference = 1
[[plant.baseline.response]]
scales = ["leaf.insertion_height"]
slope = 1
)");
    EXPECT_NEAR(campaign.reach - rigid.reach, (density - 1) * .2, 1e-9);
}

TEST(Plasticity, ReactionNormsAreTraits) {
    const Campaign campaign =
        parse_campaign(sample_text("", R"([plant.baseline.plasticity]
reference = 6
[[plant.baseline.trait]]
name = "width_slope"
per = "plant"
scales = ["leaf.width"]
over_density = true
unit = "1"
range = [-0.5, 0.5]
)",
                                   "\"traits\""),
                       "sample.toml");
    const Case chosen = cases(campaign).at(0);
    EXPECT_EQ(baseline_genome(campaign), Genome{0});
    const auto width = [&](double slope) {
        return at_density(campaign, chosen, 0,
                          grow(campaign, Genome{slope}).front())
            .leaves[0]
            .width;
    };
    EXPECT_EQ(width(0), .08);
    EXPECT_DOUBLE_EQ(width(.3), .08 * std::pow(density / 6, .3));
}

TEST(Plasticity, FaultsAreReportedTogether) {
    const std::string all =
        problem_of(sample_text("", R"([[plant.baseline.response]]
scales = ["leaf.widht"]
slope = 0.1
[[plant.baseline.response]]
slope = 0.1
[[plant.baseline.response]]
scales = ["stalk.height"]
slope = [0.1, 0.2]
[[plant.baseline.trait]]
name = "length"
sets = ["leaf.length"]
over_density = true
unit = "m"
range = [0.1, 1]
[[plant.baseline.trait]]
name = "width"
scales = ["leaf.width"]
over_density = true
unit = "1"
range = [-1, 1]
)",
                               "\"traits\""));
    for (const char* part :
         {"plasticity.reference is not given",
          "response.scales names \"leaf.widht\"", "leaf.width",
          "response has neither scales nor shifts",
          "response.slope has 2 values for stalk.height",
          "trait length sets a measure over density",
          "trait width is a slope over density"})
        EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
    EXPECT_NE(problem_of(sample_text("", R"([plant.baseline.plasticity]
turn = 0.5
turning = [9, 4]
)")),
              "");
}

}  // namespace
}  // namespace ideotype
