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

//! Three leaves of three leaflets each; the first points across the row.
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

Mesh built(const Plant& plant) {
    return build_plant(plant, {broad_cells * 3 / 2, 8});
}

double area_in(const Mesh& mesh, const std::string& group) {
    const std::vector<double> areas = face_areas(mesh);
    double sum = 0;
    for (std::size_t f = 0; f < areas.size(); ++f)
        if (mesh.groups[mesh.face_group[f]].name == group) sum += areas[f];
    return sum;
}

//! Returns the midrib of a leaflet at its base or tip.
glm::dvec3 end_of(const Mesh& mesh, std::uint32_t leaflet, bool is_tip) {
    return mesh
        .vertices[leaflet * per_leaflet + (is_tip ? 5 * broad_cells : 0) + 2];
}

TEST(Leaflets, BeginWherePetioleAndRachisEnd) {
    const Plant plant = broad_plant();
    const Mesh mesh = built(plant);
    const Leaf& leaf = plant.leaves[0];
    const double lean = 30 * degree, along = leaf.insertion_angle * degree;
    const glm::dvec3 end{
        plant.stalk.radius(0) + petiole_length * std::sin(lean), 0,
        0.25 + petiole_length * std::cos(lean)};
    const glm::dvec3 middle =
        end + rachis * glm::dvec3(std::sin(along), 0, std::cos(along));
    const glm::dvec3 expected[] = {end, middle, end};
    for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_LT(glm::distance(end_of(mesh, i, false), expected[i]), 1e-12);
    EXPECT_EQ(mesh.groups[4].name, "stalk_petiole");
    EXPECT_NEAR(area_in(mesh, "stalk_petiole"),
                3 * std::numbers::pi * 0.004 * (petiole_length + rachis), 1e-9);
}

TEST(Leaflets, PointToEqualStepsOfAzimuth) {
    const Mesh mesh = built(broad_plant());
    const double first = end_of(mesh, 0, true).z - end_of(mesh, 0, false).z;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const glm::dvec3 way = end_of(mesh, i, true) - end_of(mesh, i, false);
        EXPECT_NEAR(std::atan2(way.x, way.y) / degree, 90 + 80. * (i - 1.),
                    1e-9);
        EXPECT_NEAR(way.z, first, 1e-12);
    }
}

TEST(Leaflets, AreOneGroupWithTheAreaOfAllOfThem) {
    Plant plant = broad_plant();
    const Mesh mesh = built(plant);
    EXPECT_EQ(organ_names(plant),
              (std::vector<std::string>{"stalk", "petiole"}));
    EXPECT_EQ(mesh.groups.size(), 5u);
    plant.blade.leaflets = 1;
    const double one = area_in(build_plant(plant, {broad_cells, 8}), "leaf01");
    EXPECT_NEAR(area_in(mesh, "leaf01") / (3 * one), 1, 1e-3);
    plant.blade.leaflets = 5;
    EXPECT_NEAR(area_in(built(plant), "leaf01") / (5 * one), 1, 1e-3);
}

TEST(Leaflets, OfOneBladeWithoutPetioleAreAsEver) {
    Plant plant = sample_plant();
    const Mesh mesh = built(plant);
    plant.blade.leaflet_divergence = 80;
    for (Leaf& leaf : plant.leaves) leaf.petiole_angle = 30;
    EXPECT_EQ(built(plant).vertices, mesh.vertices);
    EXPECT_EQ(built(plant).faces, mesh.faces);
    EXPECT_EQ(organ_names(plant), std::vector<std::string>{"stalk"});
}

TEST(Leaflets, StayWherePetiolesAreNotPresent) {
    Plant plant = broad_plant();
    const Mesh mesh = built(plant);
    set_present(plant, "petiole", false);
    EXPECT_EQ(organ_names(plant), std::vector<std::string>{"stalk"});
    EXPECT_EQ(end_of(built(plant), 1, true), end_of(mesh, 1, true));
}

TEST(Leaflets, VaryWithTheirLeafAndKeepTheirArea) {
    const Plant line = broad_plant();
    const Mesh mesh = built(line);
    RandomStream random{1, Purpose::variation};
    const PlantVariation variation{
        .insertion_angle = {15}, .azimuth = {60}, .height = .05, .roll = {20}};
    for (int i = 0; i < 20; ++i) {
        const Mesh other = built(deviating(line, variation, random));
        EXPECT_EQ(other.faces, mesh.faces);
        EXPECT_NEAR(area_in(other, "leaf02") / area_in(mesh, "leaf02"), 1, .01);
    }
    EXPECT_NEAR(plant_area(built(scaled(line, .5))).leaves,
                plant_area(mesh).leaves / 4, 1e-12);
    EXPECT_NEAR(area_in(built(scaled(line, .5)), "stalk_petiole"),
                area_in(mesh, "stalk_petiole") / 4, 1e-12);
}

TEST(Internodes, AreStackedAndScaledByTraits) {
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

TEST(Internodes, LeaveOtherLeavesWhereTheyAre) {
    Plant plant = sample_plant();
    plant.leaves[1].internode = 0.3;
    stack_internodes(plant);
    EXPECT_DOUBLE_EQ(plant.leaves[1].insertion_height, 0.4);
    EXPECT_EQ(plant.leaves[2].insertion_height, 1.6);
    EXPECT_EQ(plant.stalk.height, 2.0);
}

TEST(Petioles, OfMeshFilesAreOfTheStalk) {
    const Group group = group_of_name("plant003_stalk_petiole");
    EXPECT_EQ(group.material, static_cast<std::uint32_t>(PlantMaterial::stalk));
    EXPECT_EQ(group.id.rank, 0u);
}

}  // namespace
}  // namespace ideotype
