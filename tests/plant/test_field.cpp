#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/plant/field.hpp"
#include "ideotype/plant/plant.hpp"
#include "sample_plant.hpp"

namespace ideotype {
namespace {

const FieldForm form{6, 4, {0.762, 0.1524}, 90, 10};

TEST(Field, PeriodIsSpacingTimesNumberWhateverTheLeavesReach) {
    const SamplePlant sample;
    const Mesh plant = build_plant(sample.traits, sample.form, {});
    const Field field = build_field(plant, form, draw_turns(form, 1, 0, 0));
    EXPECT_DOUBLE_EQ(field.period_x, 6 * 0.762);
    EXPECT_DOUBLE_EQ(field.period_y, 4 * 0.1524);
    EXPECT_EQ(field.mesh.faces.size(), 24 * plant.faces.size());
    EXPECT_NEAR(leaf_area(field.mesh), 24 * leaf_area(plant), 1e-9);
}

TEST(Field, EveryPlantIsTurnedByItsOwnDraw) {
    const auto turns = draw_turns(form, 1, 0, 0);
    EXPECT_EQ(std::set<double>(turns.begin(), turns.end()).size(), 24u);
    for (const double turn : turns) EXPECT_LE(std::abs(turn), 10);
    EXPECT_EQ(draw_turns(form, 1, 0, 0), turns);
    EXPECT_NE(draw_turns(form, 2, 0, 0), turns);
    EXPECT_NE(draw_turns(form, 1, 1, 0), turns);
    EXPECT_NE(draw_turns(form, 1, 0, 1), turns);
}

TEST(Field, TurningByAnAngleEqualsChangingTheLeafAzimuths) {
    SamplePlant sample;
    const FieldForm single{1, 1, {0.76, 0.15}, 90, 10};
    const Field turned =
        build_field(build_plant(sample.traits, sample.form, {}), single, {7.5});
    for (LeafTraits& traits : sample.traits) traits.azimuth += 7.5;
    const Field changed =
        build_field(build_plant(sample.traits, sample.form, {}), single, {0});
    const std::size_t leaf_vertices = 3 * 13 * 3;
    for (std::size_t v = 0; v < leaf_vertices; ++v) {
        EXPECT_NEAR(turned.mesh.vertices[v].x, changed.mesh.vertices[v].x,
                    1e-12);
        EXPECT_NEAR(turned.mesh.vertices[v].y, changed.mesh.vertices[v].y,
                    1e-12);
    }
}

TEST(Field, RefusesAWrongNumberOfTurns) {
    const SamplePlant sample;
    const Mesh plant = build_plant(sample.traits, sample.form, {});
    EXPECT_THROW(build_field(plant, form, {0, 0}), Error);
}

}  // namespace
}  // namespace ideotype
