// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "random_leaves.hpp"
#include "reference.hpp"

namespace ideotype {
namespace {

Mesh sheet(double x, double y) {
    Mesh mesh;
    mesh.groups.push_back({"sheet"});
    add_sheet(mesh, {0.2, 0.2}, 0.5, 0);
    for (glm::dvec3& v : mesh.vertices) v = {v.x + x, v.y + y, v.z};
    return mesh;
}

bool is_hit(const RayScene& scene, double x, double y) {
    Hit hit;
    return scene.intersect({x, y, 1}, {0, 0, -1}, 2, hit);
}

TEST(RayScene, OverhangingFacesReEnterOnTheOtherSide) {
    const RayScene scene(widest_device(), sheet(0.9, 0.95), 1, 1);
    EXPECT_TRUE(is_hit(scene, 0.95, 0.99));
    EXPECT_TRUE(is_hit(scene, 0.05, 0.99));
    EXPECT_TRUE(is_hit(scene, 0.95, 0.10));
    EXPECT_TRUE(is_hit(scene, 0.05, 0.10));
    EXPECT_FALSE(is_hit(scene, 0.5, 0.5));
    EXPECT_FALSE(is_hit(scene, 0.15, 0.10));
}

TEST(RayScene, ShiftsByWholePeriodsAreTheSameScene) {
    const RayScene far_away(widest_device(), sheet(0.9 + 300, 0.95 - 70), 1, 1);
    EXPECT_TRUE(is_hit(far_away, 0.05, 0.10));
    EXPECT_FALSE(is_hit(far_away, 0.5, 0.5));
}

TEST(RayScene, AFaceLargerThanTheCellCoversItSeveralTimes) {
    Mesh mesh;
    mesh.groups.push_back({"sheet"});
    add_sheet(mesh, {3.5, 0.1}, 0.5, 0);
    const RayScene scene(widest_device(), mesh, 1, 1);
    EXPECT_GE(scene.faces(), 4u);
    EXPECT_TRUE(is_hit(scene, 0.7, 0.05));
}

TEST(RayScene, HitsLieOnTheFace) {
    const RayScene scene(widest_device(), sheet(0.4, 0.4), 1, 1);
    Hit hit;
    const double slope = 1e-3;
    ASSERT_TRUE(scene.intersect({0.5, 0.5, 0.5 + slope * 0.03}, {1, 0, -slope},
                                2, hit));
    EXPECT_NEAR(hit.position.z, 0.5, 1e-9);
    EXPECT_NEAR(hit.position.x, 0.53, 2e-3);
    EXPECT_NEAR(std::abs(hit.normal.z), 1, 1e-12);
}

TEST(RayScene, FacesBelowTheSoilOrWithoutAreaAreLeftOut) {
    Mesh mesh = sheet(0.4, 0.4);
    add_sheet(mesh, {1, 1}, -0.1, 0);
    mesh.faces.push_back({0, 0, 1, 1});
    mesh.face_group.push_back(0);
    EXPECT_EQ(RayScene(widest_device(), mesh, 1, 1).faces(), 1u);
}

TEST(RayScene, BothHalvesOfAFaceWithThreeCornersHaveItsNormal) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1.5}};
    mesh.faces = {{0, 1, 2, 2}};
    mesh.groups = {{"leaf01"}};
    mesh.face_group = {0};
    const RayScene scene(widest_device(), mesh, 2, 2);
    const auto& normals = scene.surfaces().normals;
    ASSERT_EQ(normals.size(), 2u);
    EXPECT_NEAR(glm::length(normals[0]), 1, 1e-12);
    EXPECT_EQ(normals[0], normals[1]);
}

TEST(RayScene, TreesOfBothKindsLeadToTheSameFaces) {
    const Mesh mesh = random_leaves(LeafAngles::spherical, 3, 1, 1);
    const RayScene by_area(widest_device(), mesh, 1, 1);
    RayScene other(widest_device(), mesh, 1, 1, BoxTree::by_order);
    RandomStream stream(1, Purpose::stream, 0, 0);
    constexpr int rays = 20000;
    int different = 0, met = 0;
    for (int i = 0; i < rays; ++i) {
        if (i == rays / 2) other.set_tree(widest_device(), BoxTree::by_area);
        const glm::dvec3 from{stream.uniform(), stream.uniform(), 1.2};
        const glm::dvec3 to{stream.uniform(), stream.uniform(), 0};
        const double distance = glm::length(to - from);
        Hit a, b;
        const bool is_a =
            by_area.intersect(from, (to - from) / distance, distance, a);
        const bool is_b =
            other.intersect(from, (to - from) / distance, distance, b);
        met += is_a;
        // At edges, rounding may decide otherwise.
        different += is_a != is_b || (is_a && a.triangle != b.triangle);
    }
    EXPECT_GT(met, rays / 2);
    EXPECT_LE(different, 2);
}

TEST(RayScene, TreeIsBuiltInOrderForFewRays) {
    EXPECT_EQ(quickest_tree(1000, 1000), BoxTree::by_order);
    EXPECT_EQ(quickest_tree(0, 0), BoxTree::by_area);
    EXPECT_EQ(quickest_tree(1e5, 1000), BoxTree::by_area);
}

TEST(RayScene, RefusesUndefinedVerticesAndEmptyPeriods) {
    Mesh broken = sheet(0, 0);
    broken.vertices[0].z = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(RayScene(widest_device(), broken, 1, 1), Error);
    EXPECT_THROW(RayScene(widest_device(), sheet(0, 0), 0, 1), Error);
}

}  // namespace
}  // namespace ideotype
