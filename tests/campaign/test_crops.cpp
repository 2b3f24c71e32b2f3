// SPDX-License-Identifier: Apache-2.0
// Crops and plants, from campaigns and from crop files.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"
#include "spec/files.hpp"
#include "temporary_folder.hpp"

namespace ideotype {
namespace {

TEST(Campaign, PlantsAreWrittenAsTheyAreRead) {
    const Campaign campaign = ames();
    const Plant b73 =
        read_crop(IDEOTYPE_CAMPAIGNS "/crops/maize.toml").baseline;
    EXPECT_EQ(b73.leaves.size(), 10u);
    const std::string text = crop_text(campaign, b73);
    EXPECT_EQ(text, crop_text(campaign, campaign.crop.baseline));
    const std::string path = temporary_file("again.toml");
    std::ofstream(path) << text;
    const Plant again = read_crop(path).baseline;
    EXPECT_EQ(crop_text(campaign, again), text);
    EXPECT_EQ(again.leaves[9].width, b73.leaves[9].width);
    EXPECT_EQ(organ_names(again), organ_names(b73));
    Plant turned = b73;
    turned.leaves[9].azimuth = b73.leaves[9].azimuth - 720;
    EXPECT_EQ(crop_text(campaign, turned), text) << "files begin at north";
    std::ofstream(path, std::ios::app) << "\n[[leaf]]\nlength = 0.5\n";
    EXPECT_THROW(read_crop(path), InputError);
    EXPECT_THROW(read_crop(path + "none"), Error);
}

TEST(Campaign, VariationOfACropFileDoesNotChangeCampaigns) {
    const std::string path = IDEOTYPE_CAMPAIGNS "/crops/soybean.toml";
    const Crop soybean = read_crop(path);
    ASSERT_TRUE(soybean.variation);
    EXPECT_EQ(soybean.variation->jitter, 180);
    EXPECT_EQ(soybean.variation->plants.insertion_angle, LeafSpread{15});
    EXPECT_FALSE(read_crop(IDEOTYPE_CAMPAIGNS "/crops/sorghum.toml").variation);
    const Campaign campaign =
        read_campaign(IDEOTYPE_CAMPAIGNS "/sorghum.toml",
                      {"plant.baseline=\"crops/maize.toml\""});
    EXPECT_TRUE(campaign.crop.variation);
    EXPECT_FALSE(campaign.spec.field.variation.is_any());
    EXPECT_EQ(campaign.resolved.find("variation"), std::string::npos);
    // A table that is valid in a crop file is also valid in a campaign with an
    // inline crop.
    const Campaign inlined = parse_campaign(
        sample_text("", "[plant.baseline.variation]\nlength = 0.1\n"),
        "sample.toml");
    EXPECT_FALSE(inlined.spec.field.variation.is_any());
    EXPECT_EQ(inlined.resolved.find("variation"), std::string::npos);
    // Unknown keys in this table are reported.
    const std::string wrong = temporary_file("wrong.toml");
    std::filesystem::copy_file(
        path, wrong, std::filesystem::copy_options::overwrite_existing);
    std::ofstream(wrong, std::ios::app) << "\n[variation.more]\n";
    EXPECT_THROW(read_crop(wrong), InputError);
}

TEST(Campaign, CropFilesDescribeTheKnownPlants) {
    const Plant b73 = ames().crop.baseline;
    EXPECT_EQ(b73.name, "b73");
    EXPECT_EQ(b73.leaves[9].width, 0.0545);
    EXPECT_EQ(b73.leaves[1].insertion_angle, 31.4);
    EXPECT_EQ(b73.leaves[0].curvature, 125);
    EXPECT_EQ(b73.leaves[9].insertion_height, 1.61);
    // The expected leaf area index is that of 86,111 plants per hectare.
    double area = 0;
    for (const Leaf& leaf : b73.leaves)
        area += 0.7455 * leaf.length * leaf.width;
    EXPECT_NEAR(area / (0.762 * 0.1524), 3.44, 0.01);
}

TEST(Campaign, ElitePlantIsLargerAndInsideThePaperBounds) {
    const Plant elite =
        read_campaign(IDEOTYPE_TEST_DATA "/campaign/elite.toml").crop.baseline;
    ASSERT_EQ(elite.leaves.size(), 10u);
    double area = 0;
    for (const Leaf& leaf : elite.leaves)
        area += 0.7455 * leaf.length * leaf.width;
    EXPECT_NEAR(area / (0.762 * 0.1524), 4.7, 0.05);
    // The leaf angles of this plant are those of version 0.2.
    const Plant b73 =
        read_crop(IDEOTYPE_CAMPAIGNS "/plants/maize_v02.toml").baseline;
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(elite.leaves[i].azimuth, b73.leaves[i].azimuth);
        EXPECT_EQ(elite.leaves[i].curvature, b73.leaves[i].curvature);
        EXPECT_EQ(elite.leaves[i].insertion_height,
                  b73.leaves[i].insertion_height);
    }
}

TEST(Campaign, TheHybridOfTodayIsMoreErectAndLargerThanThatOfThe1980s) {
    const Plant now =
        read_crop(IDEOTYPE_CAMPAIGNS "/crops/maize_hybrid.toml").baseline;
    const Plant before =
        read_crop(IDEOTYPE_CAMPAIGNS "/plants/maize_hybrid_1980s.toml")
            .baseline;
    ASSERT_EQ(now.leaves.size(), before.leaves.size());
    double sum = 0, area = 0;
    std::vector<double> change;
    for (std::size_t i = 0; i < now.leaves.size(); ++i) {
        const Leaf& leaf = now.leaves[i];
        change.push_back(before.leaves[i].insertion_angle -
                         leaf.insertion_angle);
        sum += change.back();
        area += 0.7455 * leaf.length * leaf.width;
        EXPECT_EQ(leaf.insertion_height, before.leaves[i].insertion_height);
        // All leaves are enlarged by the same factor.
        EXPECT_NEAR(leaf.length / before.leaves[i].length, 1.147, .002);
        EXPECT_NEAR(leaf.width / before.leaves[i].width, 1.147, .002);
    }
    EXPECT_NEAR(sum / 11, 6, .01);
    EXPECT_NEAR(change.back() / change[5], 8, .05);
    EXPECT_NEAR(change.front(), change[5], .01);
    EXPECT_NEAR(area, .630, .001);
}

TEST(Campaign, EveryCropFileOfTheProjectIsAPlant) {
    const std::map<std::string, std::size_t> leaves{{"maize", 10},
                                                    {"maize_hybrid", 11},
                                                    {"sorghum", 16},
                                                    {"soybean", 12},
                                                    {"cowpea", 10},
                                                    {"elite", 10},
                                                    {"maize_v02", 10},
                                                    {"iowa_T8", 10},
                                                    {"iowa_JN3208-1", 9},
                                                    {"iowa_JN3801-1", 12},
                                                    {"maize_hybrid_1980s", 11}};
    std::size_t count = 0;
    for (const char* place : {"/crops", "/plants"})
        for (const auto& file : std::filesystem::directory_iterator(
                 std::string(IDEOTYPE_CAMPAIGNS) + place)) {
            if (file.path().extension() != ".toml") continue;
            EXPECT_EQ(read_crop(file.path().string()).baseline.leaves.size(),
                      leaves.at(file.path().stem().string()));
            ++count;
        }
    EXPECT_EQ(count, leaves.size());
}

TEST(Campaign, ATableOfLeavesIsRefusedWithTheCommandThatMakesACropFile) {
    const std::string table = IDEOTYPE_CAMPAIGNS "/plants/Dea_2008.csv";
    const std::string message =
        table +
        " is a table (but a plant is given as a crop file); make a crop file "
        "of it: "
        "ideotype fit " +
        table;
    try {
        read_crop(table);
        FAIL() << "a table is a crop";
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), table + ":1:1: " + message);
    }
    std::string text = read_text(IDEOTYPE_CAMPAIGNS "/ames_quick.toml");
    const std::string baseline = "\"crops/maize.toml\"";
    text.replace(text.find(baseline), baseline.size(),
                 "\"plants/Dea_2008.csv\"");
    try {
        read_campaign_text(text, IDEOTYPE_CAMPAIGNS "/mine.toml");
        FAIL() << "a table is a baseline";
    } catch (const InputError& error) {
        ASSERT_EQ(error.problems().size(), 1u) << error.what();
        EXPECT_EQ(error.problems()[0].what, message);
    }
}

TEST(Campaign, BoundsApplyToFreeTraitsOnly) {
    const auto place =
        std::filesystem::temp_directory_path() / "ideotype_erect_leaves";
    std::filesystem::create_directories(place);
    std::ofstream(place / "erect.toml") << std::regex_replace(
        known_crop("maize").value(),
        std::regex("\ninsertion_angle = [0-9.]+\n"), "\ninsertion_angle = 5\n");
    const auto campaign_with = [&](const std::string& lines) {
        return read_campaign_text(
            "name = \"mine\"\n"
            "[[site]]\nname = \"a\"\nlatitude = 42.0\n"
            "longitude = -93.6\nutc_offset = -5\n"
            "[[day]]\ndate = 2025-08-07\nstart = 07:00:00\n"
            "end = 20:00:00\n"
            "[[spacing]]\nrow = 0.762\nplant = 0.1524\n"
            "[plant]\nbaseline = \"erect.toml\"\n" +
                lines,
            (place / "mine.toml").string());
    };
    // Commands that do not search accept the plant.
    const Campaign mine = campaign_with("bounds = \"biological\"\n");
    EXPECT_EQ(mine.crop.baseline.leaves[8].insertion_angle, 5);
    EXPECT_THROW(require_breedable(mine), InputError);
    const std::string advice = mine.outside_bounds.back().what;
    const std::size_t begin = advice.find("[plant.bounds]\n");
    ASSERT_NE(begin, std::string::npos) << advice;
    EXPECT_NE(advice.find("\ninsertion_angle = [5, 80]"), std::string::npos)
        << advice;
    require_breedable(campaign_with(advice.substr(begin) + "\n"));
    std::filesystem::remove_all(place);
}

TEST(Campaign, CropFilesStateOpticsAndCapacityOfLeaves) {
    const Campaign campaign =
        read_campaign(IDEOTYPE_CAMPAIGNS "/quickstart.toml");
    EXPECT_EQ(campaign.spec.plant.crop.optics[0].leaf.reflectance, .06);
    EXPECT_EQ(campaign.spec.plant.crop.optics[0].leaf.transmittance, .03);
    ASSERT_TRUE(campaign.photosynthesis);
    EXPECT_EQ(campaign.photosynthesis->profile, CapacityProfile::rank);
    EXPECT_EQ(campaign.photosynthesis->rank_capacity.size(), 13u);
    // Optics of the campaign replace those of the crop. Evaluating light alone
    // requires no photosynthetic rates.
    EXPECT_EQ(ames().spec.plant.crop.optics[0].leaf.reflectance, .05);
    EXPECT_FALSE(ames().photosynthesis);
}

//! Returns the rates of the leaves of the sample campaign with the given
//! [photosynthesis] table.
std::vector<LeafRates> rates_with(const std::string& table) {
    return sample("", "[photosynthesis]\n" + table).photosynthesis->rates;
}

//! Returns the first problem of the sample campaign with the given
//! [photosynthesis] table.
std::string problem_with(const std::string& table) {
    try {
        rates_with(table);
    } catch (const InputError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

TEST(Campaign, ARateInFullLightGivesTheCapacity) {
    const auto leaf = std::get<HyperbolaLeaf>(
        rates_with("phi = 0.067\ntheta = 0.83\nrate_2000 = 50\n").front());
    EXPECT_NEAR(leaf.response.gross(2000), 50, 1e-12);
    EXPECT_NEAR(leaf.response.amax, 55.06, 0.005);
    // Leaves may differ in their rates.
    const std::vector<LeafRates> leaves =
        rates_with("rate_2000 = [30]\nphi = [0.05]\n");
    EXPECT_NEAR(std::get<HyperbolaLeaf>(leaves.back()).response.gross(2000), 30,
                1e-12);
    const Campaign stated = sample("", "[photosynthesis]\nrate_2000 = 52\n");
    const auto number = [&](const std::string& name) {
        for (const LeafNumber& each : stated.leaves.front().numbers)
            if (each.name == name) return each;
        return LeafNumber{};
    };
    EXPECT_NEAR(number("amax").values.at(0), 63.929, 1e-3);
    EXPECT_EQ(number("amax").file, number("rate_2000").file);
    EXPECT_EQ(number("rate_2000").values, std::vector{52.});
    EXPECT_EQ(parse_campaign(stated.resolved, "again.toml").resolved,
              stated.resolved);
    EXPECT_NE(problem_with("amax = 50\nrate_2000 = 40\n")
                  .find("photosynthesis.rate_2000 is given with "
                        "photosynthesis.amax (each follows from the other); "
                        "remove one of them"),
              std::string::npos);
    EXPECT_NE(problem_with("rate_2000 = 120\n")
                  .find("photosynthesis.rate_2000 is 120 (the quantum yield "
                        "photosynthesis.phi of 0.06 gives less than 120 at "
                        "2000 umol m-2 s-1, whatever the capacity); use less, "
                        "or a larger phi"),
              std::string::npos);
    EXPECT_NE(problem_with("model = \"collatz\"\nrate_2000 = 40\n")
                  .find("photosynthesis.rate_2000 is not a parameter of the "
                        "model \"collatz\""),
              std::string::npos);
}

TEST(Campaign, KeysOfACampaignReplaceTheCapacityOfItsCrop) {
    const auto leaf_with = [](const std::string& setting) {
        return read_campaign(IDEOTYPE_CAMPAIGNS "/quickstart.toml", {setting})
            .photosynthesis->rates.front();
    };
    const auto amax_with = [&](const std::string& setting) {
        return std::get<HyperbolaLeaf>(leaf_with(setting)).response.amax;
    };
    EXPECT_NEAR(amax_with("seed=1"), 63.929, 1e-3);
    EXPECT_EQ(amax_with("photosynthesis.amax=50"), 50);
    EXPECT_NEAR(amax_with("photosynthesis.rate_2000=50"), 60.714, 1e-3);
    EXPECT_NE(amax_with("photosynthesis.theta=0.8"), 50);
    // Parameters of the crop's model are not passed to another model.
    const auto collatz =
        std::get<CollatzLeaf>(leaf_with("photosynthesis.model=\"collatz\""));
    EXPECT_EQ(collatz.vmax, CollatzLeaf{}.vmax);
    EXPECT_EQ(collatz.respiration, CollatzLeaf{}.respiration);
}

TEST(Campaign, CropsWithoutPhotosynthesisCauseAWarningWhereCarbonCounts) {
    const auto warnings = [](const std::string& more,
                             const std::string& top = "") {
        return parse_campaign(sample_text(top, more), "sample.toml").warnings;
    };
    const std::string carbon = "[objective]\nmaximise = \"carbon_balance\"\n";
    EXPECT_TRUE(warnings("").empty()) << "light needs no photosynthesis";
    // The warning is given once, whatever the number of cases.
    const std::vector<Problem> doubts =
        warnings(carbon +
                     "[[traits]]\nname = \"a\"\nfree = [\"length\"]\n"
                     "[[traits]]\nname = \"b\"\nfree = [\"width\"]\n",
                 "replicates = 3\n");
    ASSERT_EQ(doubts.size(), 1u);
    EXPECT_TRUE(to_string(doubts.front())
                    .starts_with("sample.toml:19:8: the crop \"single\" has no "
                                 "[photosynthesis] (its leaves assimilate by "
                                 "the default, which is right for C4 crops"))
        << to_string(doubts.front());
    EXPECT_NE(
        doubts.front().what.find("with model = \"farquhar\" for a C3 crop, "
                                 "or \"hyperbola\" or \"collatz\" for a C4"),
        std::string::npos);
    // Axes of an atlas also require the costs of carbon.
    EXPECT_EQ(warnings("[search]\noptimizer = \"atlas\"\n[[search.axes]]\n"
                       "quantity = \"net_assimilation\"\nrange = [0, 2]\n")
                  .size(),
              1u);
    for (const char* stated : {"model = \"hyperbola\"", "amax = 30",
                               "model = \"farquhar\"\nvcmax = 80"})
        EXPECT_TRUE(
            warnings(carbon + "[photosynthesis]\n" + stated + "\n").empty())
            << stated;
    EXPECT_EQ(
        warnings(carbon + "[photosynthesis]\nprofile = \"none\"\n").size(), 1u);
    // Components take their leaves from their crop files.
    const std::string neighbour =
        "[photosynthesis]\nmodel = \"farquhar\"\n[[component]]\n"
        "name = \"other\"\nrows = [2]\n[component.crop]\nname = \"grass\"\n"
        "[[component.crop.leaf]]\nlength = 0.3\nwidth = 0.03\n"
        "insertion_angle = 40\ncurvature = 60\nazimuth = 90\n"
        "insertion_height = 0.2\n";
    const std::vector<Problem> others = warnings(carbon + neighbour);
    ASSERT_EQ(others.size(), 1u);
    EXPECT_TRUE(others.front().what.starts_with("the crop \"grass\" has no"));
}

TEST(Campaign, EveryCropOfTheProjectStatesItsPhotosynthesis) {
    for (const char* place : {"/crops", "/plants"})
        for (const auto& file : std::filesystem::directory_iterator(
                 std::string(IDEOTYPE_CAMPAIGNS) + place)) {
            if (file.path().extension() != ".toml") continue;
            const Campaign campaign = read_campaign(
                IDEOTYPE_CAMPAIGNS "/ames_quick.toml",
                {"plant.baseline=" + file.path().string(), "light.paths=64",
                 "plant.bounds=traits", "objective.maximise=net_assimilation"});
            for (const Problem& each : campaign.warnings)
                EXPECT_EQ(each.what.find("photosynthesis"), std::string::npos)
                    << to_string(each);
            EXPECT_NE(campaign.leaves.front().file, "") << file.path();
        }
}

TEST(Campaign, ExportedCropsDoNotStateDefaultPhotosynthesis) {
    const Campaign campaign = sample();
    EXPECT_EQ(
        crop_text(campaign, campaign.crop.baseline).find("photosynthesis"),
        std::string::npos);
    const Campaign stated =
        sample("", "[photosynthesis]\nmodel = \"farquhar\"\n");
    EXPECT_NE(
        crop_text(stated, stated.crop.baseline).find("model = \"farquhar\""),
        std::string::npos);
}

TEST(Campaign, BiologicalBoundsFollowEachLeaf) {
    const Campaign campaign =
        read_campaign(IDEOTYPE_TEST_DATA "/campaign/elite.toml");
    const auto bounds = [&](const std::string& name) {
        for (const Gene& gene : gene_space(campaign, cases(campaign)[0]))
            if (gene.name == name) return Range{gene.lower, gene.upper};
        return Range{};
    };
    // Leaf 4 is 0.92 m long and 0.102 m wide.
    EXPECT_DOUBLE_EQ(bounds("leaf04_length").lower, 0.65 * 0.92);
    EXPECT_EQ(bounds("leaf04_length").upper, 1.10);
    EXPECT_DOUBLE_EQ(bounds("leaf04_width").lower, 0.65 * 0.102);
    EXPECT_DOUBLE_EQ(bounds("leaf04_width").upper, 1.35 * 0.102);
    EXPECT_EQ(bounds("leaf04_insertion_angle").lower, 10);
    EXPECT_EQ(bounds("leaf04_insertion_angle").upper, 80);
    // Leaf 10 is 0.50 m long.
    EXPECT_EQ(bounds("leaf10_length").lower, 0.40);
    EXPECT_DOUBLE_EQ(bounds("leaf10_length").upper, 1.35 * 0.50);
}

//! Returns the sample campaign with the given lines instead of the angles of
//! its leaf.
std::string with_leaf(const std::string& lines) {
    std::string text = sample_text();
    for (const char* key : {"insertion_angle = ", "curvature = "}) {
        const std::size_t begin = text.find(key);
        text.erase(begin, text.find('\n', begin) - begin + 1);
    }
    const std::string leaf = "[[plant.baseline.leaf]]\n";
    return text.insert(text.find(leaf) + leaf.size(), lines);
}

TEST(Campaign, AnglesOfALeafFollowFromItsMidrib) {
    const Campaign campaign = parse_campaign(
        with_leaf("midrib = [[0, 0], [10, 10], [25, 10]]\n"), "a.toml");
    const Leaf& leaf = campaign.crop.baseline.leaves[0];
    EXPECT_NEAR(leaf.insertion_angle, 45, 1e-9);
    EXPECT_NEAR(leaf.curvature, 45, 1e-9);
    // Reading the resolved text yields the same plant.
    EXPECT_EQ(parse_campaign(campaign.resolved, "a.toml").resolved,
              campaign.resolved);
}

TEST(Campaign, MidribsWithoutADirectionAreRefused) {
    const auto tells = [](const std::string& lines, const char* words) {
        const std::string told = problem_of(with_leaf(lines));
        EXPECT_NE(told.find(words), told.npos) << told;
    };
    tells("midrib = [[1, 1], [1, 1]]\n", "no two different points");
    tells("midrib = [[1, 1, 1], [2, 2, 2]]\n", "list of [out, up]");
    tells("", "missing key 'insertion_angle'");
}

}  // namespace
}  // namespace ideotype
