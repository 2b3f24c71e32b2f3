// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/pieces.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {
namespace {

//! Blades of so many square cells along x and across y, each of 1 cm.
Mesh blades(int count, int along, int across) {
    Mesh mesh;
    mesh.groups = {{"leaf01", Tissue::leaf}, {"stalk", Tissue::stalk}};
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
    const Pieces pieces = cut_leaves(blades(2, 12, 2), {}, 8);
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
        return cut_leaves(mesh, {}, pieces).mesh.face_group;
    };
    const std::vector<std::uint32_t> two = groups(2), all = groups(16);
    for (std::uint32_t f = 0; f < 16; ++f)
        EXPECT_EQ(two[f], two[f / 8 * 8]) << "a half is one end";
    EXPECT_NE(two[0], two[15]);
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), 16u);
}

TEST(Pieces, AreNeverOfTwoBladesOrPlants) {
    const Mesh apart = blades(3, 6, 2);
    Mesh touching = blades(1, 6, 2);
    std::vector<std::uint32_t> plant(touching.faces.size());
    for (std::size_t f = 6; f < plant.size(); ++f) plant[f] = 1;
    for (const std::size_t most : {1, 2, 5, 48}) {
        const Pieces pieces = cut_leaves(apart, {}, most);
        EXPECT_LE(pieces.count, 3 * std::min<std::size_t>(most, 12));
        std::map<std::uint32_t, std::set<std::size_t>> blades_of;
        for (std::size_t f = 0; f < apart.faces.size(); ++f)
            blades_of[pieces.mesh.face_group[f]].insert(f / 12);
        for (const auto& [piece, of] : blades_of) EXPECT_EQ(of.size(), 1u);
        const Pieces of_plants = cut_leaves(touching, plant, most);
        std::map<std::uint32_t, std::set<std::uint32_t>> plants_of;
        for (std::size_t f = 0; f < plant.size(); ++f)
            plants_of[of_plants.mesh.face_group[f]].insert(plant[f]);
        for (const auto& [piece, of] : plants_of) EXPECT_EQ(of.size(), 1u);
    }
}

TEST(Rates, OfGroupsGoByTheNumbersOfLeaves) {
    Photosynthesis photosynthesis;
    photosynthesis.profile = CapacityProfile::none;
    photosynthesis.rates = {HyperbolaLeaf{{.06, .7, 30}},
                            HyperbolaLeaf{{.06, .7, 40}}};
    const auto capacity = [&](const std::vector<Group>& groups) {
        std::vector<double> result;
        for (const LeafRates& each : rates_of_groups(
                 photosynthesis, groups, std::vector<double>(groups.size(), 1)))
            result.push_back(std::get<HyperbolaLeaf>(each).response.amax);
        return result;
    };
    EXPECT_EQ(capacity({{"plant1_leaf02", Tissue::leaf},
                        {"leaf01", Tissue::leaf},
                        {"plant2_leaf02", Tissue::leaf}}),
              (std::vector{40., 30., 40.}));
    EXPECT_THROW(capacity({{"leaf01", Tissue::leaf}, {"tip", Tissue::leaf}}),
                 Error);
    EXPECT_THROW(capacity({{"leaf01", Tissue::leaf},
                           {"leaf02", Tissue::leaf},
                           {"leaf03", Tissue::leaf}}),
                 Error);
}

}  // namespace
}  // namespace ideotype
