// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "field_of_two_leaves.hpp"
#include "ideotype/canopy/field.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/crop/plant.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

const FieldForm form{6, 4, {0.762, 0.1524}, 10};

Field drawn(const Plant& plant, const FieldForm& in,
            const Randomness& randomness) {
    Scene scene;
    scene.components = {component_of(plant, in)};
    scene.cell = cell_of(in);
    return draw_field(scene, randomness);
}

std::vector<double> azimuths(const FieldForm& in,
                             const Randomness& randomness) {
    Component component;
    set_places(component, in);
    return draw_plant_azimuths(component, randomness);
}

TEST(Field, PeriodIsSpacingTimesNumberWhateverTheLeavesReach) {
    const Plant sample = sample_plant();
    const Mesh plant = build_plant(sample, {});
    const Field field = drawn(sample, form, {1, 0, 0});
    EXPECT_DOUBLE_EQ(field.cell.period_x, 6 * 0.762);
    EXPECT_DOUBLE_EQ(field.cell.period_y, 4 * 0.1524);
    EXPECT_EQ(field.mesh.faces.size(), 24 * plant.faces.size());
    EXPECT_NEAR(plant_area(field.mesh).leaves, 24 * plant_area(plant).leaves,
                1e-9);
}

TEST(Field, EveryPlantIsTurnedByItsOwnDraw) {
    const auto turns = azimuths(form, {1, 0, 0});
    EXPECT_EQ(std::set<double>(turns.begin(), turns.end()).size(), 24u);
    for (const double turn : turns) EXPECT_LE(std::abs(turn), 10);
    EXPECT_EQ(azimuths(form, {1, 0, 0}), turns);
    EXPECT_NE(azimuths(form, {2, 0, 0}), turns);
    EXPECT_NE(azimuths(form, {1, 1, 0}), turns);
    EXPECT_NE(azimuths(form, {1, 0, 1}), turns);
}

TEST(Field, AFractionOfPlantsPointsAcrossTheRow) {
    FieldForm many{50, 40, {0.762, 0.1524}, 10};
    many.variation.across_row = 0.7;
    int across = 0;
    for (const double turn : azimuths(many, {1, 0, 0})) {
        EXPECT_GE(turn, -45);
        EXPECT_LT(turn, 135);
        across += turn < 45;
    }
    // The tolerance is four standard errors.
    EXPECT_NEAR(across / 2000., 0.7, 4 * std::sqrt(.7 * .3 / 2000));
}

TEST(Field, PlantsTurnTowardsTheWidestGap) {
    Component component;
    set_places(component, {50, 40, {0.762, 0.1524}, 90});
    const std::vector<double> random =
        draw_plant_azimuths(component, {1, 0, 0});
    component.turn = 0.6;
    const std::vector<double> across =
        draw_plant_azimuths(component, {1, 0, 0});
    component.is_gap_along_row = true;
    const std::vector<double> along = draw_plant_azimuths(component, {1, 0, 0});
    for (std::size_t i = 0; i < random.size(); ++i) {
        // A plane of leaves has the same direction after half a turn.
        EXPECT_NEAR(std::remainder(across[i], 180),
                    .4 * std::remainder(random[i], 180), 1e-9);
        EXPECT_NEAR(std::remainder(along[i] - 90, 180),
                    .4 * std::remainder(random[i] - 90, 180), 1e-9);
    }
}

TEST(Field, AFractionOfPlantsIsMissingOrLate) {
    const Plant sample = sample_plant();
    const Mesh plant = build_plant(sample, {});
    FieldForm gaps = form;
    gaps.variation.missing = 0.1;  // 2.4 of 24
    gaps.variation.late = 0.25;
    std::set<std::size_t> numbers, places;
    double plants = 0, area = 0;
    constexpr int fields = 200;
    for (std::uint32_t generation = 0; generation < fields; ++generation) {
        const Field field = drawn(sample, gaps, {1, generation, 0});
        const std::size_t present =
            field.mesh.faces.size() / plant.faces.size();
        numbers.insert(present);
        EXPECT_EQ(field.face_plant.back() + 1, present);
        places.insert(static_cast<std::size_t>(field.mesh.vertices.front().y /
                                               form.spacing.plant));
        plants += static_cast<double>(present) / fields;
        area +=
            plant_area(field.mesh).leaves / plant_area(plant).leaves / fields;
    }
    EXPECT_EQ(numbers, (std::set<std::size_t>{21, 22}));
    EXPECT_GT(places.size(), 1u);  // fields without the first
    EXPECT_NEAR(plants, 24 - 2.4, 4 * .5 / std::sqrt(fields));
    EXPECT_NEAR(area, 24 - 2.4 - 6 * (1 - late_size * late_size), .2);
}

TEST(Field, OfManyMissingPlantsOneStays) {
    const Plant sample = sample_plant();
    FieldForm two{2, 1, {0.762, 0.1524}, 10};
    two.variation.missing = 1;
    EXPECT_FALSE(drawn(sample, two, {1, 0, 0}).mesh.faces.empty());
}

std::vector<Place> places(const FieldForm& in, const Randomness& randomness) {
    Scene scene;
    set_places(scene.components.emplace_back(), in);
    return draw_places(scene, randomness).front();
}

TEST(Field, PositionsDeviateByTheirStandardDeviationsFromTheLattice) {
    FieldForm many{50, 40, {0.762, 0.1524}, 10};
    const std::vector<Place> lattice = places(many, {1, 0, 0});
    many.variation.position = 0.03;
    many.variation.position_across = 0.01;
    const std::vector<Place> drawn = places(many, {1, 0, 0});
    const auto count = static_cast<double>(drawn.size());
    double along = 0, across = 0, both = 0, furthest = 0;
    for (std::size_t p = 0; p < drawn.size(); ++p) {
        EXPECT_EQ(drawn[p].row, lattice[p].row);
        const double y = (drawn[p].y - lattice[p].y) / 0.03;
        const double x = (drawn[p].x - lattice[p].x) / 0.01;
        along += y * y / count;
        across += x * x / count;
        both += x * y / count;
        furthest = std::max({furthest, std::abs(x), std::abs(y)});
    }
    // The variance of a standard normal distribution truncated at 3 is 0.995.
    // The tolerances are four standard errors.
    EXPECT_NEAR(along, 0.995, 4 * std::sqrt(2 / count));
    EXPECT_NEAR(across, 0.995, 4 * std::sqrt(2 / count));
    EXPECT_NEAR(both, 0, 4 / std::sqrt(count));
    EXPECT_LE(furthest, 3 + 1e-9);
    EXPECT_GT(furthest, 2.5);
}

std::vector<double> y_of(const std::vector<Place>& drawn) {
    std::vector<double> y;
    for (const Place& place : drawn) y.push_back(place.y);
    return y;
}

TEST(Field, PositionsAreCommonToAllPlantsOfAGeneration) {
    FieldForm varied = form;
    varied.variation.position = 0.03;
    const std::vector<double> first = y_of(places(varied, {1, 0, 0}));
    EXPECT_NE(y_of(places(varied, {1, 1, 0})), first);
    EXPECT_NE(y_of(places(varied, {1, 0, 1})), first);
    EXPECT_NE(y_of(places(varied, {2, 0, 0})), first);
    // The random positions along the row do not depend on other variation.
    varied.variation.missing = 0.1;
    varied.variation.length = 0.2;
    varied.variation.across_row = 0.7;
    varied.variation.position_across = 0.01;
    EXPECT_EQ(y_of(places(varied, {1, 0, 0})), first);
}

//! Returns the positions of points relative to the first point of their plant.
std::vector<glm::dvec3> points_from_the_first(const Field& field) {
    std::vector<glm::dvec3> points;
    glm::dvec3 first(0);
    for (std::size_t f = 0; f < field.mesh.faces.size(); ++f) {
        const glm::dvec3 v = field.mesh.vertices[field.mesh.faces[f][0]];
        if (f == 0 || field.face_plant[f] != field.face_plant[f - 1]) first = v;
        points.push_back(v - first);
    }
    return points;
}

TEST(Field, PositionsChangeNoOtherDraw) {
    FieldForm varied = form;
    varied.variation = {.length = .2, .width = .2, .azimuth = {20}};
    varied.variation.missing = 0.1;
    varied.variation.late = 0.2;
    varied.variation.across_row = 0.7;
    const Field on_the_lattice = drawn(sample_plant(), varied, {1, 0, 0});
    varied.variation.position = 0.03;
    const Field moved = drawn(sample_plant(), varied, {1, 0, 0});
    EXPECT_EQ(moved.face_plant, on_the_lattice.face_plant);
    EXPECT_EQ(moved.plant_row, on_the_lattice.plant_row);
    const auto before = points_from_the_first(on_the_lattice);
    const auto after = points_from_the_first(moved);
    ASSERT_EQ(before.size(), after.size());
    bool has_moved = false;
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_NEAR(glm::distance(before[i], after[i]), 0, 1e-12);
    for (std::size_t v = 0; v < moved.mesh.vertices.size(); ++v) {
        EXPECT_EQ(moved.mesh.vertices[v].x, on_the_lattice.mesh.vertices[v].x);
        EXPECT_EQ(moved.mesh.vertices[v].z, on_the_lattice.mesh.vertices[v].z);
        has_moved |=
            moved.mesh.vertices[v].y != on_the_lattice.mesh.vertices[v].y;
    }
    EXPECT_TRUE(has_moved);
}

TEST(Field, ACutPlotKeepsTheLeafAreaOfPlantsThatLeaveTheirPlaces) {
    FieldForm plot{8, 8, {0.762, 0.1524}, 10};
    plot.boundary = Boundary::isolated;
    plot.border_rows = 2;
    plot.variation.position = 0.05;
    const double line = plant_area(build_plant(sample_plant(), {})).leaves;
    double area = 0;
    constexpr int fields = 50;
    for (std::uint32_t generation = 0; generation < fields; ++generation)
        area += plant_area(drawn(sample_plant(), plot, {1, generation, 0}).mesh)
                    .leaves /
                (16 * line * fields);
    EXPECT_NEAR(area, 1, .03);
}

TEST(Field, TurningByAnAngleEqualsChangingTheLeafAzimuths) {
    Plant sample = sample_plant();
    FieldForm single{1, 1, {0.76, 0.15}, 10};
    const double turn = azimuths(single, {1, 0, 0}).front();
    const Field turned = drawn(sample, single, {1, 0, 0});
    for (Leaf& leaf : sample.leaves) leaf.azimuth += turn;
    single.jitter = 0;
    const Field changed = drawn(sample, single, {1, 0, 0});
    const std::size_t leaf_vertices = 3 * 13 * 3;
    for (std::size_t v = 0; v < leaf_vertices; ++v) {
        EXPECT_NEAR(turned.mesh.vertices[v].x, changed.mesh.vertices[v].x,
                    1e-12);
        EXPECT_NEAR(turned.mesh.vertices[v].y, changed.mesh.vertices[v].y,
                    1e-12);
    }
}

TEST(Field, APlotHasTheGroundOfItsPlants) {
    const Plant sample = sample_plant();
    FieldForm plot = form;
    plot.boundary = Boundary::isolated;
    const Mesh plant = build_plant(sample, {});
    const Field field = drawn(sample, plot, {1, 0, 0});
    EXPECT_EQ(field.cell.boundary, Boundary::isolated);
    EXPECT_NEAR(field.cell.ground_area, 24 * 0.762 * 0.1524, 1e-12);
    EXPECT_EQ(field.mesh.faces.size(), 24 * plant.faces.size());
}

TEST(Field, ACutPlotEndsAtItsEdge) {
    const Plant sample = sample_plant();
    FieldForm plot = form;
    plot.boundary = Boundary::isolated;
    plot.border_rows = 1;
    const Mesh plant = build_plant(sample, {});
    const Field field = drawn(sample, plot, {1, 0, 0});
    EXPECT_NEAR(field.cell.ground_area, 4 * 2 * 0.762 * 0.1524, 1e-12);
    // The leaf area that is cut off at the edge equals the area that neighbours
    // extend across it.
    EXPECT_NEAR(plant_area(field.mesh).leaves / (8 * plant_area(plant).leaves),
                1, .2);
    const double half_a_face = 0.1;
    for (const auto& face : field.mesh.faces)
        for (const std::uint32_t v : face) {
            EXPECT_GT(field.mesh.vertices[v].x, 0.762 - half_a_face);
            EXPECT_LT(field.mesh.vertices[v].x, 5 * 0.762 + half_a_face);
        }
    plot.border_rows = 2;
    EXPECT_THROW(drawn(sample, plot, {1, 0, 0}), Error);
}

TEST(Field, EveryFaceKnowsItsPlantAlsoInACutPlot) {
    const Plant sample = sample_plant();
    FieldForm plot = form;
    plot.boundary = Boundary::isolated;
    plot.border_rows = 1;
    const Mesh plant = build_plant(sample, {});
    const Field field = drawn(sample, plot, {1, 0, 0});
    ASSERT_EQ(field.face_plant.size(), field.mesh.faces.size());
    // The stalks are at the positions of their plants.
    const std::uint32_t stalk =
        static_cast<std::uint32_t>(plant.groups.size() - 1);
    std::set<std::uint32_t> standing;
    for (std::size_t f = 0; f < field.mesh.faces.size(); ++f) {
        if (field.mesh.face_group[f] != stalk) continue;
        const std::uint32_t p = field.face_plant[f];
        standing.insert(p);
        const glm::dvec3& v = field.mesh.vertices[field.mesh.faces[f][0]];
        EXPECT_NEAR(v.x, (p / 4 + 0.5) * 0.762, 0.02);
        EXPECT_NEAR(v.y, (p % 4 + 0.5) * 0.1524, 0.02);
    }
    EXPECT_EQ(standing, (std::set<std::uint32_t>{5, 6, 9, 10, 13, 14, 17, 18}));
}

TEST(Field, ACutPlotKeepsNoVertexWithoutAFace) {
    const Plant sample = sample_plant();
    FieldForm plot = form;
    plot.boundary = Boundary::isolated;
    plot.border_rows = 1;
    const Mesh plant = build_plant(sample, {});
    const Field field = drawn(sample, plot, {1, 0, 0});
    std::set<std::uint32_t> used;
    for (const auto& face : field.mesh.faces)
        used.insert(face.begin(), face.end());
    EXPECT_EQ(used.size(), field.mesh.vertices.size());
    EXPECT_EQ(*used.rbegin(), field.mesh.vertices.size() - 1);
}

//! Components use independent random numbers. An additional component therefore
//! does not change the preceding ones.
TEST(Field, HasThePlantsOfAllComponents) {
    const Plant sample = sample_plant();
    Scene scene;
    scene.components = {component_of(sample, form)};
    scene.cell = cell_of(form);
    set_places(scene.components[0], form, {0, 2, 4});
    const Field alone = draw_field(scene, {1, 0, 0});
    scene.components.push_back(scene.components[0]);
    set_places(scene.components[1], form, {1, 3, 5});
    scene.objects = {{"post", build_plant(sample, {})}};
    const Field both = draw_field(scene, {1, 0, 0});
    const std::size_t faces = build_plant(sample, {}).faces.size();
    ASSERT_EQ(alone.mesh.faces.size(), 12 * faces);
    ASSERT_EQ(both.mesh.faces.size(), (24 + 1) * faces);
    EXPECT_EQ(both.first_plant, (std::vector<std::uint32_t>{0, 12, 24}));
    for (std::size_t v = 0; v < alone.mesh.vertices.size(); ++v)
        EXPECT_EQ(both.mesh.vertices[v], alone.mesh.vertices[v]);
    const std::size_t groups = build_plant(sample, {}).groups.size();
    for (std::size_t f = 0; f < both.mesh.faces.size(); ++f) {
        const std::uint32_t group = both.mesh.face_group[f];
        EXPECT_EQ(group / groups, std::min<std::size_t>(f / (12 * faces), 2));
        EXPECT_EQ(both.mesh.groups[group].id.component, group / groups);
    }
    EXPECT_EQ(scene.components[0].ground_per_plant, 2 * 0.762 * 0.1524);
}

TEST_F(TwoLeaves, AFieldForEachRandomisationAgreesWithOne) {
    const Estimate one = evaluated().par().light.day.leaves;
    const Estimate each = evaluated(Fields::each).par().light.day.leaves;
    EXPECT_NE(one.mean, each.mean);
    EXPECT_NEAR(one.mean / each.mean, 1, .05);
}

TEST_F(TwoLeaves, PlantsThatDifferHaveTheMeanLeafAreaOfTheirFields) {
    const double line = evaluated().lai;
    request.scene.components[0].variation = {.length = .2, .width = .2};
    const double one = evaluated().lai;
    EXPECT_NE(one, line);
    EXPECT_NEAR(one, line, .3 * line);
    // Each of eight fields contains 8 leaves.
    const CanopyReport many = evaluated(Fields::each);
    EXPECT_NEAR(many.lai, line, 3 * .3 * line / 8);
    EXPECT_NE(many.lai, one);
    request.randomness.generation = 1;
    EXPECT_NE(evaluated().lai, one);
}

//! The cell contains one plant and repeats. Moving the plant within the cell,
//! or across its edge, therefore changes no light.
TEST_F(TwoLeaves, APlantThatLeavesTheCellHasTheSameLight) {
    request.accuracy = {1 << 14, 16};
    const FieldForm single{1, 1, {.76, .15, 90}};
    request.scene.cell = cell_of(single);
    Component& component = request.scene.components[0];
    set_places(component, single);
    const CanopyReport inside = evaluated(Fields::each);
    component.variation.position = .15;
    const CanopyReport anywhere = evaluated(Fields::each);
    const Estimate before = inside.par().light.day.leaves;
    const Estimate after = anywhere.par().light.day.leaves;
    EXPECT_NE(before.mean, after.mean);
    EXPECT_NEAR(before.mean, after.mean,
                4 * std::hypot(before.standard_error, after.standard_error));
    EXPECT_NEAR(inside.lai, anywhere.lai, 1e-9);
}

//! The standard error includes the differences between fields.
TEST_F(TwoLeaves, FieldsOfPlantsThatDifferAreLessCertain) {
    request.accuracy = {4096, 16};
    const Estimate alike = evaluated(Fields::each).par().light.day.leaves;
    request.scene.components[0].variation = {.2, .2, {15}, {30}, .1};
    const Estimate differing = evaluated(Fields::each).par().light.day.leaves;
    EXPECT_GT(differing.standard_error, 1.5 * alike.standard_error);
    EXPECT_LT(evaluated().par().light.day.leaves.standard_error,
              differing.standard_error / 2);
}

TEST_F(TwoLeaves, RandomisationsAreDividedAmongFields) {
    request.scene.components[0].photosynthesis.emplace();
    request.scene.components[0].variation = {.2, .2, {15}, {30}, .1};
    request.accuracy = {2048, 32, 0, 8};
    const CanopyReport report = evaluate(request, device);
    EXPECT_EQ(report.randomisations(), 8u);
    EXPECT_EQ(report.assimilation->gross.tallies.size(), 8u);
    EXPECT_EQ(report.paths, 2048u * 32u);
    const Estimate of_eight = report.par().light.day.leaves;
    const Estimate of_one = evaluated().par().light.day.leaves;
    const Estimate of_each = evaluated(Fields::each).par().light.day.leaves;
    EXPECT_GT(of_eight.standard_error, 1.5 * of_one.standard_error);
    EXPECT_NEAR(
        of_eight.mean, of_each.mean,
        4 * std::hypot(of_eight.standard_error, of_each.standard_error));
}

//! The tolerance limits only the error of light, not the error due to
//! differences between fields.
TEST_F(TwoLeaves, AToleranceHoldsForAllFieldsTogether) {
    request.accuracy = {1 << 16, 16, .004};
    const std::uint64_t one = evaluate(request, device).paths;
    request.accuracy.fields = 4;
    const std::uint64_t four = evaluate(request, device).paths;
    EXPECT_LT(four, 2 * one);
    EXPECT_GT(4 * four, one);
}

}  // namespace
}  // namespace ideotype
