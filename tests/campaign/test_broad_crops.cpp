// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <gtest/gtest.h>

#include "sample_campaign.hpp"
#include "temporary_folder.hpp"

namespace ideotype {
namespace {

std::string crop_file(const std::string& name) {
    return IDEOTYPE_CAMPAIGNS "/crops/" + name + ".toml";
}

//! A crop of one leaf with a petiole, for which no insertion height is stated.
std::string broad_text(const std::string& leaf, const std::string& more) {
    std::string text = sample_text("", more);
    const std::string height = "insertion_height = 0.2\n";
    return text.replace(text.find(height), height.size(), leaf);
}

class BroadCrop : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Known, BroadCrop,
                         ::testing::Values("soybean", "cowpea"));

TEST_P(BroadCrop, TrifoliatesHaveTheAreaOfTheirMiddleLeaflet) {
    const Plant plant = read_crop(crop_file(GetParam())).baseline;
    const Mesh mesh = build_plant(plant, {});
    const std::vector<double> areas = face_areas(mesh);
    std::vector<double> of_groups(mesh.groups.size());
    for (std::size_t f = 0; f < areas.size(); ++f)
        of_groups[mesh.face_group[f]] += areas[f];
    for (std::size_t i = 0; i < plant.leaves.size(); ++i)
        EXPECT_NEAR(of_groups[i] / (3 * .673 * plant.leaves[i].length *
                                    plant.leaves[i].width),
                    1, .01);
}

TEST_P(BroadCrop, StandsAboveTheSoilAndIsAMetreHighOrLess) {
    const Mesh mesh =
        build_plant(read_crop(crop_file(GetParam())).baseline, {});
    double lowest = 9, highest = 0;
    for (const glm::dvec3& v : mesh.vertices) {
        lowest = std::min(lowest, v.z);
        highest = std::max(highest, v.z);
    }
    EXPECT_GE(lowest, 0);
    EXPECT_GT(highest, .7);
    EXPECT_LT(highest, 1.1);
}

TEST_P(BroadCrop, IsWrittenAsItIsRead) {
    const Campaign campaign = sample();
    const Crop crop = read_crop(crop_file(GetParam()));
    const std::string text = crop_text(campaign, crop.baseline);
    EXPECT_EQ(text.find("insertion_height"), std::string::npos);
    const std::string path = temporary_file("again.toml");
    std::ofstream(path) << text;
    const Plant again = read_crop(path).baseline;
    EXPECT_EQ(crop_text(campaign, again), text);
    EXPECT_EQ(build_plant(again, {}).vertices,
              build_plant(crop.baseline, {}).vertices);
}

TEST(BroadCrops, UnusedKeysAreNotWritten) {
    const std::string text = sample().resolved;
    for (const char* key : {"petiole", "leaflet", "rachis", "internode"})
        EXPECT_EQ(text.find(key), std::string::npos) << key;
}

TEST(BroadCrops, WrongKeysAreReportedWithTheirLine) {
    const auto problem = [](const std::string& leaf, const std::string& more) {
        return problem_of(broad_text(leaf, more));
    };
    EXPECT_EQ(problem("internode = 0.2\n", ""), "");
    EXPECT_NE(problem("", "").find("missing key 'insertion_height'"),
              std::string::npos);
    EXPECT_NE(
        problem("internode = 0.2\npetiole_lenght = 0.1\n", "")
            .find("sample.toml:26:1: unknown key 'petiole_lenght' in [leaf] "
                  "(it would be ignored); did you mean 'petiole_length'?"),
        std::string::npos);
    EXPECT_NE(
        problem("internode = 0.2\n", "[plant.baseline.blade]\nleaflets = 3\n")
            .find("sample.toml:27:12: blade.leaflets is 3 (all of them "
                  "would point the same way)"),
        std::string::npos);
    EXPECT_NE(problem("internode = 0.2\n",
                      "[[plant.baseline.trait]]\nname = \"height\"\n"
                      "per = \"plant\"\nscales = [\"stalk.height\"]\n"
                      "unit = \"1\"\nrange = [0.5, 2]\n")
                  .find("trait height acts on stalk.height (which follows from "
                        "the internodes); act on leaf.internode"),
              std::string::npos);
}

TEST(BroadCrops, OrgansOfACampaignMayLeavePetiolesOut) {
    const std::string leaf = "internode = 0.2\npetiole_length = 0.1\n";
    const auto list_organs = [&](const std::string& organs) {
        std::string text = broad_text(leaf, "");
        text.insert(text.find("bounds = "), organs);
        return organ_names(parse_campaign(text, "x").crop.baseline);
    };
    EXPECT_EQ(list_organs(""), (std::vector<std::string>{"stalk", "petiole"}));
    EXPECT_EQ(list_organs("organs = [\"stalk\"]\n"),
              std::vector<std::string>{"stalk"});
}

TEST(BroadCrops, LayersReachTheTipsOfLeavesOnPetioles) {
    const auto reach = [](const std::string& leaf) {
        return parse_campaign(broad_text("internode = 0.2\n" + leaf, ""), "x")
            .reach;
    };
    EXPECT_NEAR(reach("petiole_length = 0.3\n"), reach("") + 0.3, 1e-12);
}

}  // namespace
}  // namespace ideotype
