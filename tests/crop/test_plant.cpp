#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/plant.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

TEST(Plant, GroupsAreLeavesFromTheLowestAndThenTheStalk) {
    const SamplePlant sample;
    const Mesh mesh = build_plant({sample.form, sample.traits, {}});
    ASSERT_EQ(mesh.groups.size(), 4u);
    EXPECT_EQ(mesh.groups[0].name, "leaf01");
    EXPECT_EQ(mesh.groups[2].name, "leaf03");
    EXPECT_EQ(mesh.groups[3].name, "stalk");
    EXPECT_EQ(mesh.groups[3].tissue, Tissue::stalk);
    EXPECT_EQ(mesh.faces.size(), mesh.face_group.size());
}

TEST(Plant, LeafAreaFollowsLengthTimesWidth) {
    const SamplePlant sample;
    double expected = 0;
    for (const LeafTraits& t : sample.traits)
        expected += 0.7455 * t.length * t.width;
    const auto area = [&](int cells) {
        return leaf_area(build_plant({sample.form, sample.traits, {cells, 8}}));
    };
    EXPECT_NEAR(area(12) / expected, 1, 0.006);
    EXPECT_NEAR(area(64) / expected, 1, 0.004);
}

TEST(Plant, AzimuthZeroIsAlongTheRowAndNinetyAcross) {
    const SamplePlant sample;
    for (const auto& [azimuth, x, y] :
         {std::array{0., 0., 1.}, {90., 1., 0.}, {270., -1., 0.}}) {
        auto traits = sample.traits;
        traits[1].azimuth = azimuth;
        const Mesh mesh = build_plant({sample.form, traits, {12, 8}});
        const glm::dvec3 tip = mesh.vertices[13 * 3 * 2 - 2];
        const double reach = std::hypot(tip.x, tip.y);
        EXPECT_NEAR(tip.x / reach, x, 1e-9);
        EXPECT_NEAR(tip.y / reach, y, 1e-9);
    }
}

TEST(Plant, StalkHasTheSideOfItsCylinder) {
    const SamplePlant sample;
    const Mesh mesh = build_plant({sample.form, sample.traits, {}});
    const auto areas = face_areas(mesh);
    double sides = 0;
    for (std::size_t f = 0; f < areas.size(); ++f)
        if (mesh.face_group[f] == 3 && areas[f] > 0.01) sides += areas[f];
    EXPECT_NEAR(sides, std::numbers::pi * 0.027 * 2.0, 1e-9);
}

TEST(Plant, StalkIsOptional) {
    SamplePlant sample;
    sample.form.stalk.is_present = false;
    EXPECT_EQ(build_plant({sample.form, sample.traits, {}}).groups.size(), 3u);
}

TEST(Plant, RefusesAWrongNumberOfLeaves) {
    SamplePlant sample;
    sample.traits.pop_back();
    EXPECT_THROW(build_plant({sample.form, sample.traits, {}}), Error);
}

}  // namespace
}  // namespace ideotype
