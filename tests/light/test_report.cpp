// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "extremes.hpp"
#include "ideotype/light/report.hpp"

namespace ideotype {
namespace {

//! Two instants with two invented tallies.
class MadeUpDay : public ::testing::Test {
  protected:
    MadeUpDay() {
        day.steps = {{8, 1800, {60, 90}, {100, 50}},
                     {9, 3600, {40, 120}, {0, 150}}};
        light = illuminate(day, SkyModel::uniform, 0);
        tallies = {
            {{{90, 20, 30, 40, 180}, {300, 0, 0, 330, 630}}, {70, 320}},
            {{{100, 10, 30, 40, 180}, {310, 0, 0, 320, 630}}, {80, 330}}};
        for (Tally& t : tallies) {
            for (double Budget::*part :
                 {&Budget::leaves, &Budget::organs, &Budget::soil,
                  &Budget::reflected, &Budget::incident}) {
                t.sources[0].*part *= 1000;
                t.sources[1].*part *= 1000;
            }
        }
    }
    LightSeries day;
    SeriesIllumination light;
    std::vector<Tally> tallies;
};

TEST_F(MadeUpDay, HasOneBeamAndOneSkyForAllInstants) {
    ASSERT_EQ(light.light.sources.size(), 2u);
    EXPECT_EQ(light.beam_of, (std::vector<int>{0, -1}));
    EXPECT_EQ(light.sky_of, (std::vector<int>{1, 1}));
    EXPECT_DOUBLE_EQ(light.light.sources[0].energy, 180e3);
    EXPECT_DOUBLE_EQ(light.light.sources[1].energy, 630e3);
}

TEST_F(MadeUpDay, AddsSourcesUpToTheDay) {
    const DayReport r = report(tallies, light);
    EXPECT_DOUBLE_EQ(r.day.incident, 810e3);
    EXPECT_DOUBLE_EQ(r.day.leaves.mean, 400e3);
    EXPECT_DOUBLE_EQ(r.day.leaves.standard_error, 10e3);
    EXPECT_DOUBLE_EQ(r.groups[1].mean, 325);
    EXPECT_NEAR(r.balance_error, 0, 1e-12);
}

TEST_F(MadeUpDay, GivesEachInstantItsBeamAndItsShareOfTheSky) {
    const DayReport r = report(tallies, light);
    ASSERT_EQ(r.steps.size(), 2u);
    // The sky of 50 W m-2 during 1800 s is 1/7 of the daily diffuse light.
    EXPECT_DOUBLE_EQ(r.steps[0].budget.incident, 150);
    EXPECT_NEAR(r.steps[0].budget.leaves.mean, 95e3 / 1800 + 305e3 * 50 / 630e3,
                1e-9);
    EXPECT_NEAR(r.steps[1].budget.leaves.mean, 305e3 * 150 / 630e3, 1e-9);
}

constexpr glm::dvec3 down{0, 0, -1};

TEST_F(MadeUpDay, HasOneSkyForAllInstantsWhenOvercast) {
    day.steps.push_back({22, 1800, {}, {}});
    light = illuminate(day, SkyModel::overcast, 0);
    ASSERT_EQ(light.light.sources.size(), 2u);
    EXPECT_EQ(light.sky_of, (std::vector<int>{1, 1, -1})) << "night";
    const SkySampler overcast({SkyModel::overcast, {}});
    EXPECT_EQ(light.light.sources[1].sky.relative_brightness(down),
              overcast.relative_brightness(down));
}

TEST_F(MadeUpDay, HasAClearSkyForEachInstantThatFollowsTheSun) {
    day.steps.push_back({10, 1800, {30, 150}, {50, 0}});
    light = illuminate(day, SkyModel::clear, 70);
    ASSERT_EQ(light.light.sources.size(), 4u);
    EXPECT_EQ(light.beam_of, (std::vector<int>{0, -1, 1}));
    EXPECT_EQ(light.sky_of, (std::vector<int>{2, 3, -1}));
    const Source& sky = light.light.sources[3];
    EXPECT_DOUBLE_EQ(sky.energy, 540e3);
    const glm::dvec3 aslant{.6, 0, -.8};
    const SkySampler clear({SkyModel::clear, {40, 50}});
    EXPECT_EQ(sky.sky.relative_brightness(down),
              clear.relative_brightness(down));
    EXPECT_EQ(sky.sky.relative_brightness(aslant),
              clear.relative_brightness(aslant));
    EXPECT_DOUBLE_EQ(light.light.energy(), day.incident());

    // Each instant receives light only from its own sources.
    tallies = {
        {{{1800, 0, 0, 0}, {3600, 0, 0, 0}, {900, 0, 0, 0}, {7200, 0, 0, 0}},
         {}},
        {{{1800, 0, 0, 0}, {3600, 0, 0, 0}, {900, 0, 0, 0}, {7200, 0, 0, 0}},
         {}}};
    const DayReport r = report(tallies, light);
    EXPECT_DOUBLE_EQ(r.steps[0].budget.leaves.mean, 1.5);
    EXPECT_DOUBLE_EQ(r.steps[1].budget.leaves.mean, 2);
    EXPECT_DOUBLE_EQ(r.steps[2].budget.leaves.mean, 2);
    EXPECT_EQ(r.steps[2].budget.incident, 50);
}

//! Six days on which the sun is lower each day; two of them represent all.
class MadeUpSeason : public ::testing::Test {
  protected:
    MadeUpSeason() {
        for (int d = 0; d < 6; ++d)
            for (int h = 0; h < 3; ++h)
                series.steps.push_back({10. + h,
                                        3600,
                                        {30. + d + 40 * h, 90. + 60 * h},
                                        {h == 2 ? 0 : 100. + d, 50},
                                        {2025, 7, 1 + d}});
        series.days = 6;
        light = illuminate(series, SkyModel::uniform, 0, Skies::shared, 2);
    }
    LightSeries series;
    SeriesIllumination light;
};

TEST_F(MadeUpSeason, HasTheSunsOfAFewDates) {
    // Beams exist for the second and the fifth day, two hours each.
    EXPECT_EQ(light.beam_of, (std::vector<int>{0, 1, -1, 0, 1, -1, 0, 1, -1, 2,
                                               3, -1, 2, 3, -1, 2, 3, -1}));
    EXPECT_EQ(light.sky_of, std::vector<int>(18, 4));
    ASSERT_EQ(light.light.sources.size(), 5u);
    EXPECT_EQ(*light.light.sources[3].direction, beam_direction({74, 150}));
    EXPECT_DOUBLE_EQ(light.light.sources[0].energy, 3600 * 303 / 6.);
    EXPECT_DOUBLE_EQ(light.light.energy(), series.incident());
}

TEST_F(MadeUpSeason, HasTheLightOfEachHourAndDay) {
    std::vector<Tally> tallies(2);
    for (Tally& tally : tallies)
        for (const Source& source : light.light.sources)
            tally.sources.push_back({.5 * source.energy});
    const DayReport r = report(tallies, light);
    EXPECT_DOUBLE_EQ(r.day.incident, series.incident());
    ASSERT_EQ(r.steps.size(), 3u);
    EXPECT_DOUBLE_EQ(r.steps[0].budget.incident, 152.5);
    EXPECT_DOUBLE_EQ(r.steps[0].budget.leaves.mean, 152.5 / 2);
    EXPECT_DOUBLE_EQ(r.steps[2].budget.leaves.mean, 50 / 2);
    ASSERT_EQ(r.dates.size(), 6u);
    EXPECT_DOUBLE_EQ(r.dates[0].mean, 3600 * 350 / 2.);
    EXPECT_DOUBLE_EQ(r.dates[5].mean, 3600 * 360 / 2.);
}

TEST_F(MadeUpSeason, MayHaveAllItsSuns) {
    light = illuminate(series, SkyModel::uniform, 0);
    EXPECT_EQ(light.light.sources.size(), 13u);
    EXPECT_EQ(illuminate(series, SkyModel::uniform, 0, Skies::shared, 7)
                  .light.sources.size(),
              13u);
    light = illuminate(series, SkyModel::clear, 0, Skies::shared, 2);
    EXPECT_EQ(light.light.sources.size(), 4u + 4u);
    // At 12:00 the sun has set, so that the instant uses the nearest sky with a
    // sun above the horizon.
    EXPECT_EQ(light.sky_of[2], light.sky_of[17]);
}

//! A leaf over black soil, of which the light is known in part.
class Certainty : public ::testing::Test {
  protected:
    //! Returns the report of the light in one second.
    DayReport seen(double side, const Optics& optics, double stalk = 0) const {
        Mesh mesh;
        mesh.groups = {{"leaf01"}, {"leaf02"}, {"stalk", {0, 1}, 1}};
        const auto add_square = [&](double size, std::uint32_t group) {
            if (size > 0) add_sheet(mesh, {size, size}, .3, group);
        };
        add_square(side, 0);
        add_square(stalk, 2);
        LightSeries day;
        day.steps = {{8, 1, {60, 90}, {1, 0}}, {9, 1, {40, 90}, {1, 0}}};
        const SeriesIllumination light = illuminate(day, SkyModel::uniform, 0);
        const RayScene scene(widest_device(), mesh, 1, 1);
        const Layers layers{.25, 3};
        return report(simulate(scene, mesh.groups, optics, light.light,
                               {512, 8}, {1, 0, 0}, layers),
                      light);
    }

    //! The light of one path: 2 J are distributed over 2 x 256 paths in each of
    //! 8 randomisations.
    static constexpr double path = 2. / 512 / 8;
};

TEST_F(Certainty, IsThatOfAPathWhereNoneHasMetALeaf) {
    const DayReport r = seen(1e-5, {});
    EXPECT_EQ(r.day.leaves.mean, 0);
    EXPECT_DOUBLE_EQ(r.day.leaves.standard_error, path);
    EXPECT_NEAR(r.day.soil.mean, 2, 1e-12);
    EXPECT_DOUBLE_EQ(r.day.soil.standard_error, path);
    EXPECT_DOUBLE_EQ(r.groups[0].standard_error, path);
    EXPECT_DOUBLE_EQ(r.layers[1].standard_error, path);
    EXPECT_DOUBLE_EQ(r.day.leaves_beam.standard_error, path);
    EXPECT_DOUBLE_EQ(r.steps[0].budget.leaves.standard_error, path);
}

TEST_F(Certainty, IsThatOfAPathWhereAllHaveMetALeaf) {
    const DayReport r = seen(1 - 1e-6, {});
    EXPECT_NEAR(r.day.leaves.mean, 2, 1e-12);
    EXPECT_DOUBLE_EQ(r.day.leaves.standard_error, path);
}

TEST_F(Certainty, IsFullForLightThatTheSceneCannotHave) {
    const DayReport r = seen(1e-5, {});
    const auto expect_none = [](Estimate x) {
        EXPECT_EQ(x.mean, 0);
        EXPECT_EQ(x.standard_error, 0);
    };
    expect_none(r.day.organs);            // no face in this group
    expect_none(r.groups[1]);             // no face in this group
    expect_none(r.layers[0]);             // no face in this layer
    expect_none(r.day.reflected);         // black surfaces
    expect_none(r.day.leaves_scattered);  // black surfaces
    expect_none(r.day.leaves_sky);        // no sky
    EXPECT_NEAR(seen(0, {}).day.soil.standard_error, 0, 1e-15);
    Optics white;
    white.materials = {{.5, .5}};
    expect_none(seen(1e-5, white).day.leaves);
}

TEST_F(Certainty, IsNoneOfStalksAndScatteredLightThatMayBeThere) {
    Optics optics;
    optics.soil_albedo = 1e-9;
    const DayReport r = seen(1e-5, optics, 2e-5);
    for (const Estimate& x :
         {r.day.organs, r.groups[2], r.day.reflected, r.day.leaves_scattered}) {
        EXPECT_EQ(x.mean, 0);
        EXPECT_DOUBLE_EQ(x.standard_error, path);
    }
}

TEST_F(Certainty, LeavesErrorsThatAreSeenAsTheyAre) {
    const DayReport r = seen(.7, {});
    EXPECT_GT(r.day.leaves.standard_error, 1.5 * path);
}

}  // namespace
}  // namespace ideotype
