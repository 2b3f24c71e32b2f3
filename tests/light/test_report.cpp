#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/light/report.hpp"

namespace ideotype {
namespace {

//! Two instants and two tallies made up by hand.
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
                 {&Budget::leaves, &Budget::stalks, &Budget::soil,
                  &Budget::reflected, &Budget::incident}) {
                t.sources[0].*part *= 1000;
                t.sources[1].*part *= 1000;
            }
        }
    }
    Day day;
    DayIllumination light;
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
    // The sky of 50 W m-2 for 1800 s is 1/7 of the day's diffuse light.
    EXPECT_DOUBLE_EQ(r.steps[0].budget.incident, 150);
    EXPECT_NEAR(r.steps[0].budget.leaves.mean, 95e3 / 1800 + 305e3 * 50 / 630e3,
                1e-9);
    EXPECT_NEAR(r.steps[1].budget.leaves.mean, 305e3 * 150 / 630e3, 1e-9);
}

TEST_F(MadeUpDay, HasOneSkyForAllInstantsWhenOvercast) {
    light = illuminate(day, SkyModel::overcast, 0);
    ASSERT_EQ(light.light.sources.size(), 2u);
    EXPECT_EQ(light.sky_of, (std::vector<int>{1, 1}));
    EXPECT_EQ(light.light.sources[1].sky.radiance().model, SkyModel::overcast);
}

TEST_F(MadeUpDay, HasAClearSkyForEachInstantThatFollowsTheSun) {
    day.steps.push_back({10, 1800, {30, 150}, {50, 0}});
    light = illuminate(day, SkyModel::clear, 70);
    ASSERT_EQ(light.light.sources.size(), 4u);
    EXPECT_EQ(light.beam_of, (std::vector<int>{0, -1, 1}));
    EXPECT_EQ(light.sky_of, (std::vector<int>{2, 3, -1}));
    const Source& sky = light.light.sources[3];
    EXPECT_DOUBLE_EQ(sky.energy, 540e3);
    EXPECT_EQ(sky.sky.radiance().model, SkyModel::clear);
    EXPECT_EQ(sky.sky.radiance().sun.zenith, 40);
    EXPECT_EQ(sky.sky.radiance().sun.azimuth, 50);
    EXPECT_DOUBLE_EQ(light.light.energy(), day.incident());

    // Each instant has the light of its own sources only.
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

}  // namespace
}  // namespace ideotype
