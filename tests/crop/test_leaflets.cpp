// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "ideotype/core/units.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "ideotype/crop/plant_variation.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

constexpr double petiole_length = 0.15, rachis = 0.03;
constexpr std::uint32_t broad_cells = 6, per_leaflet = 5 * (broad_cells + 1);

//! Makes a plant with three leaves of three leaflets each. The first leaf
//! points across the row.
Plant broad_plant() {
    Plant plant = sample_plant();
    plant.blade.leaflets = 3;
    plant.blade.leaflet_divergence = 80;
    plant.blade.rachis_length = rachis;
    plant.petiole.diameter = 0.004;
    for (Leaf& leaf : plant.leaves) {
        leaf.length = 0.12;
        leaf.width = 0.08;
        leaf.petiole_length = petiole_length;
        leaf.petiole_angle = 30;
        leaf.internode = 0.25;
    }
    stack_internodes(plant);
    return plant;
}

Mesh build(const Plant& plant) {
    return build_plant(plant, {broad_cells * 3 / 2, 8});
}

//! Returns the end of a leaflet's midrib at its base or its tip.
glm::dvec3 find_end(const Mesh& mesh, std::uint32_t leaflet, bool is_tip) {
    return mesh
        .vertices[leaflet * per_leaflet + (is_tip ? 5 * broad_cells : 0) + 2];
}

TEST(Leaflets, BladesBeginWherePetioleAndRachisEnd) {
    const Plant plant = broad_plant();
    const Mesh mesh = build(plant);
    const Leaf& leaf = plant.leaves[0];
    const double lean = 30 * degree, along = leaf.insertion_angle * degree;
    const glm::dvec3 end{
        plant.stalk.radius(0) + petiole_length * std::sin(lean), 0,
        0.25 + petiole_length * std::cos(lean)};
    const glm::dvec3 middle =
        end + rachis * glm::dvec3(std::sin(along), 0, std::cos(along));
    const glm::dvec3 expected[] = {end, middle, end};
    for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_LT(glm::distance(find_end(mesh, i, false), expected[i]), 1e-12);
    EXPECT_EQ(mesh.groups[4].name, "stalk_petiole");
    EXPECT_NEAR(group_area(mesh, "stalk_petiole"),
                3 * std::numbers::pi * 0.004 * (petiole_length + rachis), 1e-9);
}

TEST(Leaflets, AzimuthsDifferByEqualSteps) {
    const Mesh mesh = build(broad_plant());
    const double first = find_end(mesh, 0, true).z - find_end(mesh, 0, false).z;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const glm::dvec3 way =
            find_end(mesh, i, true) - find_end(mesh, i, false);
        EXPECT_NEAR(std::atan2(way.x, way.y) / degree, 90 + 80. * (i - 1.),
                    1e-9);
        EXPECT_NEAR(way.z, first, 1e-12);
    }
}

TEST(Leaflets, LeafletsOfALeafShareOneGroupWithTheirArea) {
    Plant plant = broad_plant();
    const Mesh mesh = build(plant);
    EXPECT_EQ(organ_names(plant),
              (std::vector<std::string>{"stalk", "petiole"}));
    EXPECT_EQ(mesh.groups.size(), 5u);
    plant.blade.leaflets = 1;
    const double one =
        group_area(build_plant(plant, {broad_cells, 8}), "leaf01");
    EXPECT_NEAR(group_area(mesh, "leaf01") / (3 * one), 1, 1e-3);
    plant.blade.leaflets = 5;
    EXPECT_NEAR(group_area(build(plant), "leaf01") / (5 * one), 1, 1e-3);
}

TEST(Leaflets, SimpleBladeWithoutPetioleIsUnaffectedByLeafletTraits) {
    Plant plant = sample_plant();
    const Mesh mesh = build(plant);
    plant.blade.leaflet_divergence = 80;
    for (Leaf& leaf : plant.leaves) leaf.petiole_angle = 30;
    EXPECT_EQ(build(plant).vertices, mesh.vertices);
    EXPECT_EQ(build(plant).faces, mesh.faces);
    EXPECT_EQ(organ_names(plant), std::vector<std::string>{"stalk"});
}

TEST(Leaflets, LeafletsStayInPlaceWithoutPetioles) {
    Plant plant = broad_plant();
    const Mesh mesh = build(plant);
    set_present(plant, "petiole", false);
    EXPECT_EQ(organ_names(plant), std::vector<std::string>{"stalk"});
    EXPECT_EQ(find_end(build(plant), 1, true), find_end(mesh, 1, true));
}

TEST(Leaflets, LeafletsVaryWithTheirLeafAndKeepTheirArea) {
    const Plant line = broad_plant();
    const Mesh mesh = build(line);
    RandomStream random{1, Purpose::variation};
    const PlantVariation variation{
        .insertion_angle = {15}, .azimuth = {60}, .height = .05, .roll = {20}};
    for (int i = 0; i < 20; ++i) {
        const Mesh other = build(deviating(line, variation, random));
        EXPECT_EQ(other.faces, mesh.faces);
        EXPECT_NEAR(group_area(other, "leaf02") / group_area(mesh, "leaf02"), 1,
                    .01);
    }
    EXPECT_NEAR(plant_area(build(scaled(line, .5))).leaves,
                plant_area(mesh).leaves / 4, 1e-12);
    EXPECT_NEAR(group_area(build(scaled(line, .5)), "stalk_petiole"),
                group_area(mesh, "stalk_petiole") / 4, 1e-12);
}

TEST(Internodes, InternodesAreStackedAndScaledByTraits) {
    Crop broad{broad_plant(), {}};
    EXPECT_DOUBLE_EQ(broad.baseline.leaves[2].insertion_height, 0.75);
    EXPECT_DOUBLE_EQ(broad.baseline.stalk.height, 0.75);
    Trait trait;
    trait.numbers = TraitNumbers::profile;
    trait.points = 3;
    trait.effect = TraitEffect::scales;
    trait.measures = {"leaf.internode", "leaf.petiole_length"};
    broad.traits = {trait};
    const Plant plant = grow(broad, {1, 2, 0.5});
    EXPECT_DOUBLE_EQ(plant.leaves[1].insertion_height, 0.75);
    EXPECT_DOUBLE_EQ(plant.leaves[2].insertion_height, 0.875);
    EXPECT_DOUBLE_EQ(plant.stalk.height, 0.875);
    EXPECT_DOUBLE_EQ(plant.leaves[1].petiole_length, 2 * petiole_length);
}

TEST(Internodes, LeavesWithoutInternodeStayInPlace) {
    Plant plant = sample_plant();
    plant.leaves[1].internode = 0.3;
    stack_internodes(plant);
    EXPECT_DOUBLE_EQ(plant.leaves[1].insertion_height, 0.4);
    EXPECT_EQ(plant.leaves[2].insertion_height, 1.6);
    EXPECT_EQ(plant.stalk.height, 2.0);
}

TEST(Petioles, PetiolesInMeshFilesAreStalkMaterial) {
    const Group group = parse_group_name("plant003_stalk_petiole");
    EXPECT_EQ(group.material, static_cast<std::uint32_t>(PlantMaterial::stalk));
    EXPECT_EQ(group.id.rank, 0u);
}

}  // namespace
}  // namespace ideotype
