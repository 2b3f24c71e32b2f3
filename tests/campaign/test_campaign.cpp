// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/hash.hpp"
#include "sample_campaign.hpp"

namespace ideotype {

TEST(Campaign, AmesIsTheStudyOfThePaper) {
    const Campaign campaign = ames();
    EXPECT_EQ(campaign.spec.name, "ames");
    EXPECT_EQ(campaign.spec.replicates, 3);
    EXPECT_EQ(campaign.search.population, 100);
    EXPECT_EQ(campaign.stop.generations, 200);
    ASSERT_EQ(campaign.spec.sites.size(), 1u);
    EXPECT_EQ(campaign.spec.sites[0].latitude, 42.0);
    EXPECT_EQ(campaign.spec.sites[0].longitude, -93.6);
    EXPECT_EQ(campaign.spec.sites[0].utc_offset, -5);
    ASSERT_EQ(campaign.spec.days.size(), 1u);
    const DaySpan& day = campaign.spec.days[0].value;
    EXPECT_EQ(day.dates[0].year, 2025);
    EXPECT_EQ(day.dates[0].month, 8);
    EXPECT_EQ(day.dates[0].day, 7);
    EXPECT_EQ(day.start, 7);
    EXPECT_EQ(day.end, 20);
    EXPECT_EQ(day.step_minutes, 30);
    ASSERT_EQ(campaign.spec.spacings.size(), 1u);
    EXPECT_EQ(campaign.spec.spacings[0].value.row, 0.762);
    EXPECT_EQ(campaign.spec.spacings[0].value.plant, 0.1524);
    EXPECT_EQ(campaign.spec.field.rows * campaign.spec.field.plants, 16);
    EXPECT_EQ(campaign.spec.field.jitter, 10);
    EXPECT_EQ(campaign.spec.plant.crop.optics[0].leaf.reflectance, 0.05);
    EXPECT_EQ(campaign.crop.baseline.leaves.size(), 10u);
}

TEST(Campaign, TheDefaultOptimizerIsAuto) {
    const Campaign campaign = sample();
    EXPECT_EQ(campaign.search.optimizer, OptimizerKind::automatic);
    // A plant of one leaf with four genes: 2.5 (4 + 3 ln 4).
    EXPECT_EQ(campaign.search.population, 20);
}

TEST(Campaign, NamesItsOptimizer) {
    const Campaign campaign = ames();
    EXPECT_EQ(campaign.search.optimizer, OptimizerKind::ga);
    EXPECT_NE(campaign.resolved.find("[search]\noptimizer = \"ga\"\n"),
              std::string::npos);
    try {
        parse_campaign(replaced(campaign.resolved, "optimizer = \"ga\"",
                                "optimizer = \"gradient\""),
                       "c.toml");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what())
                      .find("search.optimizer is \"gradient\" (not one of its "
                            "values); use \"auto\""),
                  std::string::npos)
            << error.what();
    }
}

TEST(Campaign, AmesQuickIsTheSameCaseWithLessWork) {
    const Campaign quick = read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml");
    const Campaign full = ames();
    EXPECT_EQ(quick.search.population, 24);
    EXPECT_EQ(quick.stop.generations, 20);
    EXPECT_EQ(quick.spec.replicates, 1);
    EXPECT_EQ(quick.sampling.tolerance, full.sampling.tolerance);
    for (const std::string& line :
         differences(full.spec, quick.spec, cases(full).front()))
        for (const std::string same :
             {"site", "day", "spacing", "traits", "field", "plant", "optics"})
            EXPECT_NE(line.rfind(same, 0), 0u) << line;
}

TEST(Campaign, DefaultsAreThoseOfThePaperExceptForTheSearch) {
    std::string text = sample_text();
    text.replace(text.find("Ames"), 1, "a");
    const std::string reduced =
        "name = \"ames\"\nreplicates = 3\n" + text.substr(text.find('\n'));
    const Campaign whole = ames();
    for (const std::string& line :
         differences(whole.spec, parse_campaign(reduced, "x").spec,
                     cases(whole).front()))
        EXPECT_TRUE(line.starts_with("plant.baseline") ||
                    line.starts_with("plant.organs") ||
                    line.starts_with("search.optimizer was \"ga\"") ||
                    line.starts_with("search.population was 100"))
            << line;
}

TEST(Campaign, WithoutAToleranceAllPathsAreTraced) {
    EXPECT_EQ(sample().sampling.tolerance, 0.005);
    EXPECT_EQ(sample("", "[light]\npaths = 512\n").sampling.tolerance, 0);
    EXPECT_EQ(sample("", "[light]\npaths = 512\ntolerance = 0.01\n")
                  .sampling.tolerance,
              0.01);
}

TEST(Campaign, EveryCampaignOfTheProjectIsValidAndItsSize) {
    const std::map<std::string, std::size_t> sizes{
        {"ames", 3},           {"bondville", 6},      {"ames_quick", 1},
        {"isolated_plot", 12}, {"latitudes", 15},     {"profiles", 6},
        {"quickstart", 3},     {"row_direction", 12}, {"same_leaf_area", 3},
        {"sorghum", 2},        {"spacings", 18},      {"trait_sets", 12},
        {"soybean", 2},        {"strip", 1},          {"alley", 1},
        {"cultivars", 1},      {"mixture", 1},        {"invader", 1},
        {"intercrop", 1},      {"agrivoltaic", 1},    {"growing_season", 1},
        {"atlas", 1},          {"maize_belt", 5}};
    std::size_t count = 0;
    for (const auto& file :
         std::filesystem::directory_iterator(IDEOTYPE_CAMPAIGNS)) {
        if (file.path().extension() != ".toml") continue;
        ++count;
        const Campaign campaign = read_campaign(file.path().string());
        EXPECT_EQ(campaign.spec.name, file.path().stem());
        ASSERT_TRUE(sizes.contains(campaign.spec.name)) << campaign.spec.name;
        EXPECT_EQ(cases(campaign).size(), sizes.at(campaign.spec.name));
        const auto& [low, high] = campaign.spec.constraints.lai;
        EXPECT_EQ(violation(campaign.spec.constraints, campaign.crop.traits,
                            campaign.crop.baseline, (low + high) / 2),
                  0)
            << campaign.spec.name << ": the baseline fails its constraints";
    }
    EXPECT_EQ(count, sizes.size());
}

TEST(Campaign, ResolvedTextReadsBackToItself) {
    const Campaign campaign = ames();
    const Campaign again = parse_campaign(campaign.resolved, "resolved");
    EXPECT_EQ(again.resolved, campaign.resolved);
    EXPECT_EQ(again.sha256, campaign.sha256);
    EXPECT_EQ(campaign.sha256, sha256(campaign.resolved));
    EXPECT_EQ(baseline_numbers(again.crop), baseline_genome(campaign));
}

TEST(Campaign, ResolvedTextKeepsUnusualValues) {
    const Campaign campaign = sample(
        "seed = 9223372036854775807\n",
        "[field]\njitter = -0.0\nboundary = \"isolated\"\nborder_rows = 1\n"
        "[constraints]\nlai = [0.1, 3.3]\n"
        "insertion_angle.falling = true\n"
        "[objective]\nmaximise = \"absorbed_par_per_leaf_area\"\n"
        "[[traits]]\nname = \"t\"\nfree = [\"azimuth\", \"length\"]\n"
        "[stop]\nwall_time = \"01:30:05\"\n",
        "{length = [0.1, 1], width = [0.05, 0.14], insertion_angle = "
        "[-0.0, 80]}");
    const Campaign again = parse_campaign(campaign.resolved, "resolved");
    EXPECT_EQ(again.resolved, campaign.resolved);
    EXPECT_EQ(again.spec.seed, 9223372036854775807u);
    EXPECT_EQ(again.stop.wall_time, 5405);
    EXPECT_EQ(again.spec.field.boundary, Boundary::isolated);
    EXPECT_EQ(again.spec.field.border_rows, 1);
    EXPECT_EQ(again.spec.constraints.lai.lower, 0.1);
    ASSERT_EQ(again.spec.constraints.traits.size(), 1u);
    EXPECT_TRUE(again.spec.constraints.traits[0].is_falling);
    EXPECT_EQ(again.spec.objective.maximised,
              std::vector<std::string>{"absorbed_par_per_leaf_area"});
    EXPECT_EQ(again.spec.trait_sets[0].value, (TraitSet{"length", "azimuth"}));
    EXPECT_EQ(again.bounds[0].lower, 0.1);
    EXPECT_EQ(again.bounds[3].upper, 360);
}

// Keys that no longer exist are ignored in histories of earlier versions.
TEST(Campaign, OfAHistoryWarnsOnceAboutKeysThatThisVersionLacks) {
    const auto of_history = [](const std::string& step,
                               const std::string& base) {
        std::string text = sample().resolved;
        for (const auto& [table, key] :
             {std::pair{"\n[search]\n", "step = " + step + "\nwindow = 4\n"},
              {"\n[plant.baseline.stalk]\n", "leaf_base = " + base + '\n'}})
            text.insert(text.find(table) + std::string(table).size(), key);
        return parse_history_campaign(text, "old.h5");
    };
    const Campaign usual = of_history("0.2", "\"surface\"");
    EXPECT_EQ(usual.spec.passed_over, (std::set<std::string>{"search.window"}));
    const Campaign other = of_history("0.5", "\"axis\"");
    EXPECT_EQ(other.resolved, sample().resolved);
    ASSERT_EQ(other.warnings.size(), sample().warnings.size() + 1);
    EXPECT_EQ(to_string(other.warnings.front()),
              "old.h5: the campaign of this history has keys that this version "
              "lacks (search.step, search.window, stalk.leaf_base); they are "
              "ignored; the version that wrote the history reads them");
    EXPECT_THROW(parse_campaign(sample().resolved + "[water]\nhot = 35\n", ""),
                 InputError);
}

TEST(Campaign, SkyIsUniformUnlessItIsNamed) {
    EXPECT_EQ(sample().spec.light.sky, SkyModel::uniform);
    for (const auto& [name, model] : {std::pair{"uniform", SkyModel::uniform},
                                      {"overcast", SkyModel::overcast},
                                      {"clear", SkyModel::clear}}) {
        const Campaign campaign =
            sample("", fmt::format("[light]\nsky = \"{}\"\n", name));
        EXPECT_EQ(campaign.spec.light.sky, model);
        const Campaign again = parse_campaign(campaign.resolved, "resolved");
        EXPECT_EQ(again.spec.light.sky, model);
        EXPECT_EQ(again.resolved, campaign.resolved);
    }
}

TEST(Campaign, ClockTimesKeepTheirSeconds) {
    const std::string text =
        replaced(replaced(sample_text(), "07:00:00", "05:00:07.125"),
                 "20:00:00", "20:00:07.125");
    const Campaign campaign = parse_campaign(text, "sample.toml");
    EXPECT_NE(campaign.resolved.find("start = 05:00:07.125000000\n"),
              std::string::npos);
    EXPECT_DOUBLE_EQ(campaign.spec.days[0].value.start, 5 + 7.125 / 3600);
    EXPECT_EQ(parse_campaign(campaign.resolved, "resolved").resolved,
              campaign.resolved);
}

TEST(Campaign, SameMeaningHasTheSameResolvedText) {
    const Campaign one = sample("seed = 1\nreplicates = 1\n");
    const Campaign other =
        sample("# a comment\nreplicates = 1\n",
               "[light]\ntolerance = 5e-3\npaths = 16_384\n");
    EXPECT_EQ(one.sha256, other.sha256);
    EXPECT_NE(one.source, other.source);
}

TEST(Campaign, ASingleTableIsAnAxisWithOneEntry) {
    const std::string text = replaced(sample_text(), "[[site]]", "[site]");
    EXPECT_EQ(parse_campaign(text, "sample.toml").resolved, sample().resolved);
}

TEST(Campaign, UnnamedEntriesAreNamedAfterTheirValues) {
    const Campaign campaign = sample();
    EXPECT_EQ(campaign.spec.days[0].name, "0807");
    EXPECT_EQ(campaign.spec.spacings[0].name, "762x152");
    ASSERT_EQ(campaign.spec.trait_sets.size(), 1u);
    EXPECT_EQ(campaign.spec.trait_sets[0].name, "all");
}

TEST(Campaign, LeavesAssimilateIfTheObjectiveOrATableRequiresIt) {
    EXPECT_FALSE(parse_campaign(sample_text(), "c").photosynthesis);
    const std::string objective =
        "[objective]\nmaximise = \"carbon_balance\"\n";
    const Campaign campaign = parse_campaign(sample_text("", objective), "c");
    ASSERT_TRUE(campaign.photosynthesis);
    EXPECT_EQ(campaign.photosynthesis->profile, CapacityProfile::exponential);
    EXPECT_NE(campaign.resolved.find("[photosynthesis]"), std::string::npos);
    EXPECT_EQ(parse_campaign(campaign.resolved, "c").resolved,
              campaign.resolved);

    const std::string table =
        "[photosynthesis]\nmodel = \"collatz\"\nvmax = [40]\nrd = 1\n"
        "profile = \"nitrogen\"\nnitrogen = 5\nweather = false\n";
    const Campaign other = parse_campaign(sample_text("", table), "c");
    ASSERT_TRUE(other.photosynthesis);
    const auto& leaf = std::get<CollatzLeaf>(other.photosynthesis->rates.at(0));
    EXPECT_EQ(leaf.vmax, 40);
    EXPECT_EQ(leaf.respiration, 1);
    EXPECT_EQ(leaf.theta, CollatzLeaf{}.theta);
    EXPECT_EQ(other.photosynthesis->nitrogen.total, 5);
    EXPECT_FALSE(other.photosynthesis->follows_weather);
    EXPECT_EQ(parse_campaign(other.resolved, "c").resolved, other.resolved);
}

TEST(Campaign, C3LeavesHaveDifferentKeys) {
    const std::string table =
        "[photosynthesis]\nmodel = \"farquhar\"\nvcmax = 90\njmax = 160\n"
        "tpu = 11\ntheta = 0.9\nbeta = 0.95\ng1 = 4\nrd = 1\n";
    const Campaign campaign = parse_campaign(sample_text("", table), "c");
    const auto& leaf =
        std::get<FarquharLeaf>(campaign.photosynthesis->rates.at(0));
    EXPECT_EQ(leaf.vcmax, 90);
    EXPECT_EQ(leaf.jmax, 160);
    EXPECT_EQ(leaf.tpu, 11);
    EXPECT_EQ(leaf.theta, .9);
    EXPECT_EQ(leaf.beta, .95);
    EXPECT_EQ(leaf.g1, 4);
    EXPECT_EQ(leaf.respiration, 1);
    EXPECT_EQ(parse_campaign(campaign.resolved, "c").resolved,
              campaign.resolved);
    const auto problem = [](const std::string& keys) {
        return problem_of(sample_text("", "[photosynthesis]\n" + keys));
    };
    EXPECT_NE(problem("model = \"farquhar\"\nvmax = 40\n")
                  .find("photosynthesis.vmax is not a parameter of the model "
                        "\"farquhar\" (but of \"collatz\"); remove it"),
              std::string::npos);
    EXPECT_NE(problem("beta = 0.9\n")
                  .find("of the model \"hyperbola\" (but of \"collatz\" or "
                        "\"farquhar\"); remove it"),
              std::string::npos);
}

TEST(Campaign, AnySingleNumberOfTheCanopyMayBeAnObjective) {
    const auto text = [](const std::string& quantity) {
        return sample_text("",
                           "[objective]\nmaximise = \"" + quantity + "\"\n");
    };
    EXPECT_FALSE(parse_campaign(text("fapar"), "c").photosynthesis);
    EXPECT_TRUE(parse_campaign(text("sunlit_lai"), "c").photosynthesis);
    EXPECT_EQ(problem_of(text("extinction_coefficient")), "");
    EXPECT_NE(problem_of(text("fparr")).find("did you mean 'fapar'?"),
              std::string::npos);
    EXPECT_NE(problem_of(text("net_assimilaton"))
                  .find("did you mean 'net_assimilation'?"),
              std::string::npos);
    // For an unknown name without a similar quantity the message lists all
    // quantities, except those that describe the method.
    const std::string message = problem_of(text("xyz"));
    EXPECT_NE(message.find("use one of absorbed_par, "), std::string::npos)
        << message;
    for (const char* own : {"paths", "capped", "balance_error"})
        EXPECT_EQ(message.find(own), std::string::npos) << message;
    EXPECT_NE(problem_of(text("extinction_coefficient") +
                         "[field]\nboundary = \"isolated\"\n")
                  .find("light enters a plot"),
              std::string::npos);
}

}  // namespace ideotype
