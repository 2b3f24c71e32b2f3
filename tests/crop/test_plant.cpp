// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/plant.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

struct Box {
    glm::dvec3 lower{9, 9, 9}, upper{-9, -9, -9};
};

Box find_box(const Mesh& mesh, std::uint32_t group) {
    Box box;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t v : mesh.faces[f])
            if (mesh.face_group[f] == group)
                for (int k = 0; k < 3; ++k) {
                    box.lower[k] = std::min(box.lower[k], mesh.vertices[v][k]);
                    box.upper[k] = std::max(box.upper[k], mesh.vertices[v][k]);
                }
    return box;
}

TEST(Plant, GroupsAreLeavesFromTheLowestAndThenTheStalk) {
    const Plant sample = sample_plant();
    const Mesh mesh = build_plant(sample, {});
    ASSERT_EQ(mesh.groups.size(), 4u);
    EXPECT_EQ(mesh.groups[0].name, "leaf01");
    EXPECT_EQ(mesh.groups[2].name, "leaf03");
    EXPECT_EQ(mesh.groups[3].name, "stalk");
    EXPECT_EQ(mesh.groups[2].id.rank, 3u);
    EXPECT_TRUE(mesh.groups[2].id.is_leaf());
    EXPECT_FALSE(mesh.groups[3].id.is_leaf());
    EXPECT_EQ(mesh.groups[3].material, 1u);
    EXPECT_EQ(mesh.faces.size(), mesh.face_group.size());
}

TEST(Plant, LeafAreaFollowsLengthTimesWidth) {
    const Plant sample = sample_plant();
    double expected = 0;
    for (const Leaf& t : sample.leaves) expected += 0.7455 * t.length * t.width;
    const auto area = [&](int cells) {
        return plant_area(build_plant(sample, {cells, 8})).leaves;
    };
    EXPECT_NEAR(area(12) / expected, 1, 0.006);
    EXPECT_NEAR(area(64) / expected, 1, 0.004);
}

TEST(Plant, AzimuthZeroIsAlongTheRowAndNinetyAcross) {
    const Plant sample = sample_plant();
    for (const auto& [azimuth, x, y] :
         {std::array{0., 0., 1.}, {90., 1., 0.}, {270., -1., 0.}}) {
        Plant plant = sample;
        plant.leaves[1].azimuth = azimuth;
        const Mesh mesh = build_plant(plant, {12, 8});
        const glm::dvec3 tip = mesh.vertices[13 * 3 * 2 - 2];
        const double reach = std::hypot(tip.x, tip.y);
        EXPECT_NEAR(tip.x / reach, x, 1e-9);
        EXPECT_NEAR(tip.y / reach, y, 1e-9);
    }
}

TEST(Plant, StalkHasTheLateralAreaOfACylinder) {
    const Plant sample = sample_plant();
    const Mesh mesh = build_plant(sample, {});
    const auto areas = face_areas(mesh);
    double sides = 0;
    for (std::size_t f = 0; f < areas.size(); ++f)
        if (mesh.face_group[f] == 3 && areas[f] > 0.01) sides += areas[f];
    EXPECT_NEAR(sides, std::numbers::pi * 0.027 * 2.0, 1e-9);
}

TEST(Plant, StalkIsOptional) {
    Plant sample = sample_plant();
    sample.stalk.is_present = false;
    EXPECT_EQ(build_plant(sample, {}).groups.size(), 3u);
}

TEST(Plant, StalksTaper) {
    Plant sample = sample_plant();
    sample.stalk = {{}, true, 1.6, 0.024, 0.011};
    EXPECT_DOUBLE_EQ(sample.stalk.radius(0), 0.012);
    EXPECT_DOUBLE_EQ(sample.stalk.radius(0.8), 0.00875);
    EXPECT_DOUBLE_EQ(sample.stalk.radius(9), 0.0055);
    // The side of a truncated cone has the area pi (r + R) times its slant
    // height.
    const double slant = std::hypot(1.6, 0.0065);
    EXPECT_NEAR(group_area(build_plant(sample, {12, 200}), "stalk") /
                    (std::numbers::pi * 0.0175 * slant +
                     std::numbers::pi * 0.0055 * 0.0055),
                1, 1e-3);
}

TEST(Plant, LeavesBeginAtTheSurfaceOfTheStalk) {
    Plant sample = sample_plant();
    const Mesh mesh = build_plant(sample, {});
    constexpr std::size_t per_leaf = 13 * 3;
    for (std::size_t leaf = 0; leaf < 3; ++leaf) {
        const glm::dvec3 base = mesh.vertices[leaf * per_leaf + 1];
        EXPECT_NEAR(std::hypot(base.x, base.y), 0.0135, 1e-12);
        EXPECT_DOUBLE_EQ(base.z, sample.leaves[leaf].insertion_height);
    }
    sample.stalk.is_present = false;
    const Mesh bare = build_plant(sample, {});
    EXPECT_NEAR(bare.vertices[1].x, 0, 1e-12);
    EXPECT_NEAR(plant_area(mesh).leaves / plant_area(bare).leaves, 1, 1e-9);
}

TEST(Plant, SheathMassDoesNotShrinkWithTheStalk) {
    Plant sample = sample_plant();
    sample.leaves[0].insertion_height = 0.5;
    sample.stalk = {{}, true, 2, 0.03, 0.01};
    sample.sheath = {{}, true, 0.2, 0.001};
    sample.stalk.density = 100;
    sample.sheath.density = 90;
    const std::vector<PlantOrgan> organs = list_organs(sample);
    ASSERT_EQ(organs.size(), 4u);
    EXPECT_EQ(organs[2].name, "petiole");
    EXPECT_FALSE(organs[2].is_present);
    // The volume of a truncated cone is pi / 12 times its height times 13 cm2.
    EXPECT_NEAR(organs[0].mass, 100 * std::numbers::pi / 12 * 2 * 13e-4, 1e-12);
    const double around = 2 * (0.025 + 0.021 + 0.014) / 2 * std::numbers::pi;
    EXPECT_NEAR(organs[1].mass, 90 * around * 0.2 * 0.001, 1e-12);
    Plant shorter = sample;
    shorter.stalk.height *= 0.7;
    for (Leaf& leaf : shorter.leaves) leaf.insertion_height *= 0.7;
    EXPECT_NEAR(list_organs(shorter)[0].mass, 0.7 * organs[0].mass, 1e-12);
    EXPECT_NEAR(list_organs(shorter)[1].mass, organs[1].mass, 1e-12);
    sample.sheath.is_present = false;
    EXPECT_EQ(list_organs(sample)[1].mass, 0);
}

TEST(Plant, GreenSheathsHaveSeparateFaces) {
    Plant sample = sample_plant();
    sample.stalk = {{}, true, 1.6, 0.02, 0.02};
    sample.sheath = {{}, true, 0.81, 0.001};
    const Mesh dead = build_plant(sample, {});
    sample.sheath.capacity = 0.1;
    const Mesh green = build_plant(sample, {});
    EXPECT_GT(green.faces.size(), dead.faces.size());
    EXPECT_TRUE(green.groups.back().assimilates());
    EXPECT_FALSE(dead.groups.back().assimilates());
    EXPECT_TRUE(dead.groups.front().assimilates());
}

TEST(Plant, SheathsCoverTheStalkBelowEachLeafAndAreNotLeaves) {
    Plant sample = sample_plant();
    const double leaves = plant_area(build_plant(sample, {})).leaves;
    sample.stalk = {{}, true, 1.6, 0.02, 0.02};
    sample.sheath = {{}, true, 0.5, 0.001};
    Mesh mesh = build_plant(sample, {});
    EXPECT_EQ(organ_names(sample),
              (std::vector<std::string>{"stalk", "sheath"}));
    EXPECT_EQ(mesh.groups.back().name, "sheath");
    EXPECT_EQ(mesh.groups.back().material, 2u);
    EXPECT_EQ(mesh.groups.back().id.organ, 2u);
    EXPECT_NEAR(plant_area(mesh).leaves, leaves, 1e-9);
    // Leaves are inserted at 0.1, 0.9 and 1.6 m. The visible parts of sheaths
    // are 0.1, 0.5 and 0.5 m long, those of the stalk 0.3 and 0.2 m. Only
    // sheaths end in flat tops.
    const auto tops = [](double radius, int count) {
        return count * 8 * std::sin(std::numbers::pi / 8) *
               std::cos(std::numbers::pi / 8) *
               std::pow(radius * std::numbers::pi / 8 /
                            std::sin(std::numbers::pi / 8),
                        2);
    };
    EXPECT_NEAR(group_area(mesh, "sheath"),
                std::numbers::pi * 0.022 * 1.1 + tops(0.011, 3), 1e-9);
    EXPECT_NEAR(group_area(mesh, "stalk"), std::numbers::pi * 0.02 * 0.5, 1e-9);
    // If sheaths are longer than all internodes, no part of the stalk is
    // visible.
    sample.sheath.length = 0.81;
    EXPECT_EQ(group_area(build_plant(sample, {}), "stalk"), 0);
}

TEST(Plant, OtherOrgansStandOnTheStalkOrAtALeaf) {
    Plant sample = sample_plant();
    sample.stalk = {{}, true, 1.6, 0.02, 0.02};
    Organ branches;
    branches.name = "branches";
    branches.count = 3;
    branches.spread = 0.1;
    branches.offset = 0.2;
    branches.length = 0.2;
    branches.base_diameter = branches.top_diameter = 0.004;
    branches.inclination = 90;
    Organ ear = branches;
    ear.name = "ear";
    ear.material = PlantMaterial::sheath;
    ear.leaf = 2;
    ear.count = 1;
    ear.offset = 0;
    ear.inclination = 0;
    sample.organs = {branches, ear};
    const Mesh mesh = build_plant(sample, {});
    ASSERT_EQ(mesh.groups.size(), 6u);
    EXPECT_EQ(mesh.groups[4].name, "stalk_branches");
    EXPECT_EQ(mesh.groups[5].name, "sheath_ear");
    const Box top = find_box(mesh, 4), side = find_box(mesh, 5);
    // Horizontal branches at 1.8, 1.85 and 1.9 m, 120 deg apart, the first
    // towards +y.
    EXPECT_NEAR(top.lower.z, 1.8, 0.003);
    EXPECT_NEAR(top.upper.z, 1.9, 0.003);
    EXPECT_NEAR(top.upper.y, 0.2, 0.003);
    EXPECT_NEAR(top.upper.x, 0.2 * std::sin(std::numbers::pi / 3), 0.003);
    // The ear is vertical, at leaf 2, which points towards -x.
    EXPECT_NEAR(side.lower.z, 0.9, 1e-9);
    EXPECT_NEAR(side.upper.z, 1.1, 1e-9);
    EXPECT_NEAR((side.lower.x + side.upper.x) / 2, -0.01, 1e-9);
    set_present(sample, "branches", false);
    EXPECT_EQ(organ_names(sample), (std::vector<std::string>{"stalk", "ear"}));
    EXPECT_EQ(build_plant(sample, {}).groups.size(), 5u);
}

}  // namespace
}  // namespace ideotype
