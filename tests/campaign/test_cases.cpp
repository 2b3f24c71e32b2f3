// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"
#include "temporary_folder.hpp"

namespace ideotype {

namespace {

constexpr auto second_spacing = "[[spacing]]\nrow = 0.381\nplant = 0.0762\n";
constexpr auto trait_sets =
    "[[traits]]\nname = \"angles\"\nfree = [\"insertion_angle\", \"azimuth\"]\n"
    "[[traits]]\nname = \"all\"\n"
    "free = [\"length\", \"width\", \"insertion_angle\", \"azimuth\"]\n";

}  // namespace

TEST(Cases, NamesJoinAllAxesInLowerCase) {
    const Campaign campaign = sample();
    const Cases campaign_cases = cases(campaign);
    ASSERT_EQ(campaign_cases.size(), 1u);
    EXPECT_EQ(campaign_cases[0].name, "ames_0807_762x152_all_r1");
    EXPECT_EQ(campaign_cases[0].index, 0);
}

TEST(Cases, ARuleOfBoundsMayChooseTheFreeTraits) {
    const std::string text =
        "name = \"b\"\n[[site]]\nname = \"a\"\nlatitude = 42\n"
        "longitude = -93\nutc_offset = -6\n[[day]]\ndate = 2025-08-07\n"
        "start = 07:00:00\nend = 20:00:00\n[[spacing]]\nrow = 0.76\n"
        "plant = 0.15\n[plant]\nbaseline = \"" IDEOTYPE_CAMPAIGNS
        "/crops/maize.toml\"\nbounds = ";
    const auto bred = [&](const std::string& rule) {
        const std::string path = temporary_file(rule + ".toml");
        std::ofstream(path) << text << '"' << rule << "\"\n";
        const Campaign campaign = read_campaign(path);
        return cases(campaign).front().traits;
    };
    EXPECT_EQ(bred("biological"),
              (TraitSet{"length", "width", "insertion_angle", "azimuth"}));
    EXPECT_EQ(bred("breedable"),
              (TraitSet{"azimuth_deviation", "leaf_plane", "height",
                        "length_profile", "width_profile",
                        "insertion_angle_profile", "curvature_profile"}));
}

TEST(Cases, ReplicatesVaryFastestThenTraitsThenSpacings) {
    const Campaign campaign =
        sample("replicates = 2\n", std::string(second_spacing) + trait_sets);
    const Cases campaign_cases = cases(campaign);
    ASSERT_EQ(campaign_cases.size(), 8u);
    EXPECT_EQ(campaign_cases[0].name, "ames_0807_762x152_angles_r1");
    EXPECT_EQ(campaign_cases[1].name, "ames_0807_762x152_angles_r2");
    EXPECT_EQ(campaign_cases[2].name, "ames_0807_762x152_all_r1");
    EXPECT_EQ(campaign_cases[4].name, "ames_0807_381x76_angles_r1");
    EXPECT_EQ(campaign_cases[4].spacing.row, 0.381);
    EXPECT_EQ(campaign_cases[1].traits,
              (TraitSet{"insertion_angle", "azimuth"}));
    EXPECT_EQ(campaign_cases[1].replicate, 2);
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(campaign_cases[static_cast<std::size_t>(i)].index, i);
}

TEST(Cases, SeedsDoNotDependOnOtherCases) {
    const Campaign small = sample();
    const Campaign large =
        sample("replicates = 3\n", std::string(second_spacing) + trait_sets);
    const Cases few = cases(small);
    const Cases many = cases(large);
    std::map<std::string, std::uint64_t> seeds;
    std::set<std::uint64_t> different;
    for (const Case& one : many) {
        seeds[one.name] = one.seed;
        different.insert(one.seed);
    }
    EXPECT_EQ(different.size(), many.size());
    ASSERT_EQ(seeds.count(few[0].name), 1u);
    EXPECT_EQ(seeds[few[0].name], few[0].seed);
}

TEST(Cases, SeedOfTheCampaignChangesAllSeeds) {
    const Campaign one = sample("seed = 1\n");
    const Campaign two = sample("seed = 2\n");
    EXPECT_NE(cases(one)[0].seed, cases(two)[0].seed);
}

TEST(Cases, AreNamedAndFoundAsTheyAreMade) {
    const Campaign campaign =
        sample("replicates = 3\n", std::string(second_spacing) + trait_sets);
    const Cases campaign_cases = cases(campaign);
    const std::vector<CaseName> names = campaign_cases.names();
    ASSERT_EQ(names.size(), 12u);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Case made = campaign_cases[i];
        EXPECT_EQ(made.name, names[i].name);
        EXPECT_EQ(made.seed, names[i].seed);
        EXPECT_EQ(made.index, names[i].index);
        EXPECT_EQ(made.trait_set_name, names[i].trait_set_name);
        EXPECT_EQ(campaign_cases.find(made.name).value().index, made.index);
    }
    EXPECT_FALSE(campaign_cases.find("none").has_value());
    EXPECT_THROW(campaign_cases.at(12), std::out_of_range);
    const Cases some = campaign_cases.part(5, 2);
    ASSERT_EQ(some.size(), 2u);
    EXPECT_EQ(some.back().name, names[6].name);
    EXPECT_EQ(some.back().index, 6);
    EXPECT_EQ(some.index(1), 6);
}

TEST(Cases, AreFoundByTheirIndexOrRefusedWithTheRange) {
    const Campaign campaign = sample("replicates = 3\n");
    EXPECT_EQ(case_at(campaign, 2, "x.toml").name, cases(campaign)[2].name);
    for (const int index : {-1, 3}) try {
            case_at(campaign, index, "x.toml");
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.exit_code(), ExitCode::usage);
            EXPECT_NE(std::string(error.what()).find("x.toml has cases 0 to 2"),
                      std::string::npos);
        }
}

TEST(Campaign, DurationsMayHaveUnits) {
    EXPECT_EQ(sample("", "[stop]\nwall_time = \"1h30m\"\n").stop.wall_time,
              5400);
}

TEST(GeneSpace, HasFourNamedGenesPerLeaf) {
    const Campaign campaign = sample();
    const GeneSpace genes = gene_space(campaign, cases(campaign)[0]);
    ASSERT_EQ(genes.size(), 4u);
    EXPECT_EQ(genes[0].name, "leaf01_length");
    EXPECT_EQ(genes[1].name, "leaf01_width");
    EXPECT_EQ(genes[2].name, "leaf01_insertion_angle");
    EXPECT_EQ(genes[3].name, "leaf01_azimuth");
    EXPECT_EQ(genes[0].unit, "m");
    EXPECT_EQ(genes[3].unit, "deg");
    EXPECT_EQ(genes[0].lower, 0.40);
    EXPECT_EQ(genes[0].upper, 1.10);
    EXPECT_EQ(genes[1].lower, 0.05);
    EXPECT_EQ(genes[1].upper, 0.14);
}

TEST(GeneSpace, OnlyAzimuthIsCircular) {
    const Campaign campaign = sample();
    const GeneSpace genes = gene_space(campaign, cases(campaign)[0]);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(genes[i].is_circular);
    EXPECT_TRUE(genes[3].is_circular);
    EXPECT_EQ(genes[3].lower, 0);
    EXPECT_EQ(genes[3].upper, 360);
}

TEST(GeneSpace, TraitSetsDetermineFreeGenes) {
    const Campaign campaign = sample("", trait_sets);
    const GeneSpace genes = gene_space(campaign, cases(campaign)[0]);
    EXPECT_FALSE(genes[0].is_free);
    EXPECT_FALSE(genes[1].is_free);
    EXPECT_TRUE(genes[2].is_free);
    EXPECT_TRUE(genes[3].is_free);
}

constexpr auto own_traits =
    "[[plant.baseline.trait]]\nname = \"height\"\nper = \"plant\"\n"
    "scales = [\"stalk.height\", \"leaf.insertion_height\"]\nunit = \"1\"\n"
    "range = [0.8, 1.2]\nbred = false\n"
    "[[plant.baseline.trait]]\nname = \"angles\"\nper = \"profile\"\npoints = "
    "3\n"
    "shifts = [\"leaf.insertion_angle\"]\nunit = \"deg\"\n"
    "range = [-20, 20]\n"
    "[[plant.baseline.trait]]\nname = \"width\"\nsets = [\"leaf.width\"]\n"
    "unit = \"m\"\nrange = [0.05, 0.14]\n";

TEST(GeneSpace, FollowsFromTheTraitsOfTheCrop) {
    const Campaign campaign = sample("", own_traits, "\"traits\"");
    const GeneSpace genes = gene_space(campaign, cases(campaign)[0]);
    ASSERT_EQ(genes.size(), 5u);
    EXPECT_EQ(genes[0].name, "leaf01_width");
    EXPECT_EQ(genes[1].name, "height");
    EXPECT_EQ(genes[1].unit, "1");
    EXPECT_EQ(genes[1].leaf, 0);
    EXPECT_FALSE(genes[1].is_free);
    EXPECT_EQ(genes[2].name, "angles_1");
    EXPECT_EQ(genes[4].name, "angles_3");
    EXPECT_EQ(genes[4].trait, "angles");
    EXPECT_EQ(genes[4].lower, -20);
    EXPECT_TRUE(genes[4].is_free);
    EXPECT_EQ(baseline_genome(campaign),
              (std::vector<double>{0.08, 1, 0, 0, 0}));
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
}

TEST(GeneSpace, OwnBoundsMayNarrowAnyTrait) {
    const Campaign campaign = sample("", own_traits, "{angles = [-5, 10]}");
    const GeneSpace genes = gene_space(campaign, cases(campaign)[0]);
    EXPECT_EQ(genes[2].lower, -5);
    EXPECT_EQ(genes[0].upper, 0.14);
    EXPECT_THROW(sample("", own_traits, "{length = [0.1, 1]}"), InputError);
}

TEST(Plant, OrgansAreChosenByTheirNames) {
    const std::string organ =
        "[[plant.baseline.organ]]\nname = \"ear\"\npresent = false\n"
        "leaf = 1\nlength = 0.2\nbase_diameter = 0.05\n";
    const auto organs = [&](const std::string& line) {
        std::string text = sample_text("", organ);
        text.insert(text.find("[plant]") + 8, line);
        return organ_names(parse_campaign(text, "x").crop.baseline);
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(organs(""), Names{"stalk"});
    EXPECT_EQ(organs("organs = []\n"), Names{});
    EXPECT_EQ(organs("organs = [\"ear\", \"sheath\"]\n"),
              (Names{"sheath", "ear"}));
    EXPECT_THROW(organs("organs = [\"eer\"]\n"), InputError);
}

}  // namespace ideotype
