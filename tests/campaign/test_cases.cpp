#include <map>
#include <set>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"

namespace ideotype {

namespace {

constexpr auto second_spacing = "[[spacing]]\nrow = 0.381\nplant = 0.0762\n";
constexpr auto trait_sets =
    "[[traits]]\nname = \"angles\"\nfree = [\"insertion_angle\", \"azimuth\"]\n"
    "[[traits]]\nname = \"all\"\n"
    "free = [\"length\", \"width\", \"insertion_angle\", \"azimuth\"]\n";

}  // namespace

TEST(Cases, NamesJoinAllAxesInLowerCase) {
    const auto all = cases(sample());
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].name, "ames_0807_762x152_all_r1");
    EXPECT_EQ(all[0].index, 0);
}

TEST(Cases, ReplicatesVaryFastestThenTraitsThenSpacings) {
    const auto all = cases(
        sample("replicates = 2\n", std::string(second_spacing) + trait_sets));
    ASSERT_EQ(all.size(), 8u);
    EXPECT_EQ(all[0].name, "ames_0807_762x152_angles_r1");
    EXPECT_EQ(all[1].name, "ames_0807_762x152_angles_r2");
    EXPECT_EQ(all[2].name, "ames_0807_762x152_all_r1");
    EXPECT_EQ(all[4].name, "ames_0807_381x76_angles_r1");
    EXPECT_EQ(all[4].spacing.row, 0.381);
    EXPECT_FALSE(all[1].traits.length);
    EXPECT_EQ(all[1].replicate, 2);
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(all[static_cast<std::size_t>(i)].index, i);
}

TEST(Cases, SeedsDoNotDependOnOtherCases) {
    const auto few = cases(sample());
    const auto many = cases(
        sample("replicates = 3\n", std::string(second_spacing) + trait_sets));
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
    EXPECT_NE(cases(sample("seed = 1\n"))[0].seed,
              cases(sample("seed = 2\n"))[0].seed);
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

TEST(Campaign, TimesMayBeWrittenInUnits) {
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

TEST(GeneSpace, TraitSetsDecideWhatIsFree) {
    const Campaign campaign = sample("", trait_sets);
    const GeneSpace genes = gene_space(campaign, cases(campaign)[0]);
    EXPECT_FALSE(genes[0].is_free);
    EXPECT_FALSE(genes[1].is_free);
    EXPECT_TRUE(genes[2].is_free);
    EXPECT_TRUE(genes[3].is_free);
}

TEST(Genome, HoldsTheTraitsInTheOrderOfTheGenes) {
    const Genome genome = to_genome(sample().baseline);
    EXPECT_EQ(genome, (Genome{0.8, 0.08, 40, 90}));
    const auto traits = to_traits({1, 2, 3, 4, 5, 6, 7, 8});
    ASSERT_EQ(traits.size(), 2u);
    EXPECT_EQ(traits[1].length, 5);
    EXPECT_EQ(traits[1].azimuth, 8);
    EXPECT_EQ(to_genome(traits), (Genome{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(Genome, PartOfALeafIsRefused) {
    EXPECT_THROW(to_traits({1, 2, 3, 4, 5}), Error);
}

}  // namespace ideotype
