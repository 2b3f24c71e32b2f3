// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {
namespace {

//! Returns blades of square cells of 1 cm, with the given numbers of cells
//! lengthwise and across.
Mesh blades(int count, int along, int across) {
    Mesh mesh;
    mesh.groups = {{"leaf01"}, {"stalk", {0, 1}, 1}};
    for (int blade = 0; blade < count; ++blade)
        for (int i = 0; i < along; ++i)
            for (int j = 0; j < across; ++j) {
                const auto first =
                    static_cast<std::uint32_t>(mesh.vertices.size());
                for (const auto& [di, dj] :
                     {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
                    mesh.vertices.emplace_back(.01 * (i + di), .01 * (j + dj),
                                               1. + blade);
                mesh.faces.push_back({first, first + 1, first + 2, first + 3});
                mesh.face_group.push_back(0);
            }
    return mesh;
}

TEST(Pieces, HaveTheAreaOfTheirLeaves) {
    const Pieces pieces = cut_leaves(blades(2, 12, 2), 8);
    ASSERT_EQ(pieces.count, 16u);
    for (std::size_t v = 0; v < pieces.count; ++v) {
        EXPECT_NEAR(pieces.area[v], 3e-4, 1e-12);
        EXPECT_NEAR(pieces.height[v], v < 8 ? 1 : 2, 1e-12);
        EXPECT_EQ(pieces.group[v], 0u);
    }
}

TEST(Pieces, HalveBladesAlongFirstAndThenAcross) {
    const Mesh mesh = blades(1, 8, 2);
    const auto groups = [&](std::size_t pieces) {
        return cut_leaves(mesh, pieces).mesh.face_group;
    };
    const std::vector<std::uint32_t> two = groups(2), all = groups(16);
    for (std::uint32_t f = 0; f < 16; ++f)
        EXPECT_EQ(two[f], two[f / 8 * 8]) << "a half is one end";
    EXPECT_NE(two[0], two[15]);
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), 16u);
}

TEST(Pieces, AreNeverOfTwoBladesOrPlants) {
    const Mesh apart = blades(3, 6, 2);
    for (const std::size_t most : {1, 2, 5, 48}) {
        const Pieces pieces = cut_leaves(apart, most);
        EXPECT_LE(pieces.count, 3 * std::min<std::size_t>(most, 12));
        std::map<std::uint32_t, std::set<std::size_t>> blades_of;
        for (std::size_t f = 0; f < apart.faces.size(); ++f)
            blades_of[pieces.mesh.face_group[f]].insert(f / 12);
        for (const auto& [piece, of] : blades_of) EXPECT_EQ(of.size(), 1u);
    }
}

//! The blade tapers linearly to a point and bends over in a half circle.
TEST(Pieces, HaveTheWidthOfTheBladeWhereTheyAre) {
    constexpr int along = 60;
    constexpr double length = .01 * along, width = .04, pi = 3.14159265358979;
    Mesh mesh = blades(1, along, 4);
    for (glm::dvec3& vertex : mesh.vertices) {
        const double far = vertex.x;
        vertex.y *= 1 - far / length;
        vertex.z = length / pi * std::sin(pi * far / length);
        vertex.x = length / pi * (1 - std::cos(pi * far / length));
    }
    const Pieces pieces = cut_leaves(mesh);
    const std::vector<double> found = local_widths(pieces);
    ASSERT_EQ(found.size(), 48u);
    const std::vector<double> areas = face_areas(pieces.mesh);
    std::vector<double> expected(pieces.count);
    for (std::size_t f = 0; f < areas.size(); ++f) {
        const double far = .01 * (static_cast<double>(f / 4) + .5);
        const std::uint32_t v = pieces.mesh.face_group[f];
        expected[v] += areas[f] / pieces.area[v] * width * (1 - far / length);
    }
    for (std::size_t v = 0; v < pieces.count; ++v)
        EXPECT_NEAR(found[v], expected[v], .1 * width) << v;
}

TEST(Pieces, OfAFieldAreListedByPlantBeforeUncutSurfaces) {
    Scene scene;
    for (const int along : {2, 3}) {
        Component& one = scene.components.emplace_back();
        one.mesh = blades(1, along, 2);
        one.places = {{0, 0}, {1, 0}};
        // The stalk has one face.
        one.mesh.faces.push_back(one.mesh.faces.front());
        one.mesh.face_group.push_back(1);
    }
    scene.objects = {{"post", scene.components[0].mesh}};
    const std::vector<Pieces> lines{cut_leaves(scene.components[0].mesh),
                                    cut_leaves(scene.components[1].mesh)};
    const std::vector<Mesh> meshes{lines[0].mesh, lines[1].mesh};
    Field field = draw_field(scene, {}, meshes);
    const Pieces all = pieces_of_field(lines, field);
    ASSERT_EQ(all.count, 2u * (4 + 6));
    ASSERT_EQ(all.mesh.groups.size(), all.count + 2 + 2);
    std::map<std::uint32_t, int> faces;  // by the group before the cut
    for (const std::uint32_t group : all.mesh.face_group)
        ++faces[all.group[group]];
    // The groups are leaf and stalk of both components, followed by the post,
    // which is not cut.
    EXPECT_EQ(faces, (std::map<std::uint32_t, int>{
                         {0, 8}, {1, 2}, {2, 12}, {3, 2}, {4, 4}, {5, 1}}));
    for (std::size_t g = 0; g < all.mesh.groups.size(); ++g) {
        const SurfaceId& id = all.mesh.groups[g].id;
        EXPECT_EQ(id.component, all.group[g] / 2) << g;
        EXPECT_EQ(id.is_object(), all.group[g] >= 4) << g;
    }
    for (std::size_t v = 0; v < all.count; ++v)
        EXPECT_EQ(all.like[v], v < 8 ? v % 4 : 8 + (v - 8) % 6) << v;
}

//! Returns the area of each group in projection from above, counting faces that
//! point upwards [m2].
std::vector<double> area_from_above(const Mesh& mesh) {
    std::vector<double> areas(mesh.groups.size());
    const auto twice = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::dvec3 u = mesh.vertices[b] - mesh.vertices[a];
        const glm::dvec3 v = mesh.vertices[c] - mesh.vertices[a];
        EXPECT_GE(u.x * v.y, u.y * v.x) << "a part is turned over";
        return u.x * v.y - u.y * v.x;
    };
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const auto& [a, b, c, d] = mesh.faces[f];
        areas[mesh.face_group[f]] += (twice(a, b, d) + twice(c, d, b)) / 2;
    }
    return areas;
}

TEST(CoarseLeaves, AreDividedAsTheyLie) {
    // The mesh joins a folded quadrilateral and a triangle; the next face
    // belongs to the stalk.
    Mesh mesh;
    mesh.vertices = {
        {0, 0, 1}, {.1, 0, 1}, {.12, .1, 1.04}, {0, .08, 1.1}, {.2, .05, .95}};
    mesh.faces = {{0, 1, 2, 3}, {1, 4, 2, 2}, {0, 1, 2, 3}};
    mesh.face_group = {0, 0, 1};
    mesh.groups = {{"leaf01"}, {"stalk", {0, 1}, 1}};
    const double seen = area_from_above(mesh)[0];
    const double area = plant_area(mesh).leaves;
    for (const auto& [tolerance, faces] : {std::pair(.01, 32u), {1e-3, 128u}}) {
        const Pieces pieces = cut_coarse_leaves(mesh, 1, tolerance);
        ASSERT_EQ(pieces.mesh.faces.size(), faces + 1);
        // Some pieces contain several faces if faces differ in area.
        EXPECT_GT(pieces.count, .8 * faces);
        EXPECT_EQ(pieces.uncut_groups, 2u);
        EXPECT_EQ(pieces.group.front(), 0u);
        EXPECT_EQ(pieces.group[pieces.mesh.face_group.back()], 1u);
        const std::vector<double> parts = area_from_above(pieces.mesh);
        EXPECT_NEAR(std::accumulate(parts.begin(), parts.end() - 1, 0.), seen,
                    1e-15);
        EXPECT_NEAR(plant_area(pieces.mesh).leaves, area, 1e-15);
    }
}

TEST(CoarseLeaves, MayHaveAGroupForEachFace) {
    Mesh mesh = blades(1, 12, 2);
    const auto cut = [&] {
        mesh.groups.assign(mesh.faces.size(), {"leaf01", {0, 0, 1}});
        std::iota(mesh.face_group.begin(), mesh.face_group.end(), 0u);
        return cut_coarse_leaves(mesh, 1, 1e-3);
    };
    EXPECT_EQ(cut().mesh.faces.size(), 24u) << "as many as built plants have";
    mesh = blades(1, 6, 2);
    EXPECT_EQ(cut().mesh.faces.size(), 192u);
}

TEST(CoarseLeaves, AreDividedLessWhereThereAreVeryMany) {
    const Mesh mesh = blades(100, 1, 1);
    for (const auto& [copies, faces] :
         {std::pair(1u, 6400u), {200u, 400u}, {400u, 100u}})
        EXPECT_EQ(cut_coarse_leaves(mesh, copies, 0).mesh.faces.size(), faces);
}

TEST(Rates, OfGroupsGoByTheRanksOfLeaves) {
    Scene scene;
    Photosynthesis& photosynthesis =
        scene.components.emplace_back().photosynthesis.emplace();
    photosynthesis.profile = CapacityProfile::none;
    photosynthesis.rates = {HyperbolaLeaf{{.06, .7, 30}},
                            HyperbolaLeaf{{.06, .7, 40}}};
    const auto capacity = [&](const std::vector<std::uint32_t>& ranks) {
        std::vector<Group> groups;
        for (const std::uint32_t rank : ranks)
            groups.push_back({"leaf", {0, 0, rank}});
        std::vector<double> result;
        for (const LeafGroup& each :
             leaf_groups(scene, groups, std::vector<double>(groups.size(), 1)))
            result.push_back(std::get<HyperbolaLeaf>(each.rates).response.amax);
        return result;
    };
    EXPECT_EQ(capacity({2, 1, 2}), (std::vector{40., 30., 40.}));
    EXPECT_THROW(capacity({1, 0}), Error);
    EXPECT_THROW(capacity({1, 2, 3}), Error);
}

}  // namespace
}  // namespace ideotype
