// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

namespace {

//! Makes a mesh with a leaf of 2 m x 1 m, a triangular leaf of 1 m2 and a stalk
//! of 3 m x 1 m.
Mesh sample_mesh() {
    Mesh mesh;
    mesh.vertices = {{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1},
                     {0, 0, 0}, {0, 1, 0}, {0, 1, 3}, {0, 0, 3}};
    mesh.faces = {{0, 1, 2, 3}, {0, 1, 2, 2}, {4, 5, 6, 7}};
    mesh.face_group = {0, 2, 1};
    mesh.groups = {{"leaf01"}, {"stalk", {0, 1}, 1}, {"leaf02"}};
    return mesh;
}

}  // namespace

TEST(FaceAreas, AreasOfQuadrilateralsAndTrianglesAreExact) {
    const std::vector<double> areas = face_areas(sample_mesh());
    ASSERT_EQ(areas.size(), 3u);
    EXPECT_DOUBLE_EQ(areas[0], 2);
    EXPECT_DOUBLE_EQ(areas[1], 1);
    EXPECT_DOUBLE_EQ(areas[2], 3);
}

TEST(FaceAreas, TwistedFaceIsSplitAlongOneDiagonal) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2, 3}};
    // Split along the diagonal between corners 1 and 3, the face consists of a
    // flat right triangle of area 1/2 and an equilateral triangle with sides
    // sqrt(2).
    EXPECT_DOUBLE_EQ(face_areas(mesh)[0], 0.5 + std::sqrt(3.0) / 2);
}

TEST(FaceAreas, DegenerateFaceHasNoArea) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 1, 1}};
    mesh.faces = {{0, 1, 1, 1}, {0, 0, 1, 1}};
    for (const double area : face_areas(mesh)) EXPECT_EQ(area, 0);
}

TEST(LeafArea, LeafAreaExcludesStalks) {
    EXPECT_DOUBLE_EQ(plant_area(sample_mesh()).leaves, 3);
    EXPECT_EQ(plant_area({}).leaves, 0);
}

}  // namespace ideotype
