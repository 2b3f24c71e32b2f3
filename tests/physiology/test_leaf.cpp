// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/physiology/leaf.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {
namespace {

double gross_assimilation(const LeafRates& leaf, const Air& air,
                          double absorbed) {
    double result = 0;
    gross(response(leaf, air), {&absorbed, 1}, &result);
    return result;
}

TEST(Leaf, OfTheHyperbolaIsItselfAt30Degrees) {
    const LeafRates leaf = HyperbolaLeaf{};
    for (const double light : {0., 100., 1500.})
        EXPECT_EQ(gross_assimilation(leaf, {30, .2}, light),
                  Hyperbola{}.gross(light));
    EXPECT_DOUBLE_EQ(dark_respiration(leaf, 30), 2);
    EXPECT_DOUBLE_EQ(dark_respiration(leaf, 20), 1);
}

TEST(Leaf, CapacityFollowsTheTemperature) {
    const Hyperbola cool = hyperbola_at({}, 15);
    EXPECT_EQ(cool.phi, .06);
    EXPECT_DOUBLE_EQ(cool.amax, 50 * c4_temperature_response(15) /
                                    c4_temperature_response(30));
    // A rate of 39 at 25 deg C corresponds to 49.9 at 30 deg C.
    EXPECT_NEAR(39 * c4_temperature_response(30) / c4_temperature_response(25),
                49.9, 2.);
    EXPECT_LT(c4_temperature_response(0), .1);
    EXPECT_LT(c4_temperature_response(45), c4_temperature_response(35));
}

TEST(Leaf, RespirationIsTiedToTheCapacityUnlessGiven) {
    HyperbolaLeaf leaf;
    leaf.response.amax = 20;
    EXPECT_DOUBLE_EQ(dark_respiration(LeafRates(leaf), 30), .8);
    EXPECT_DOUBLE_EQ(dark_respiration(scaled(leaf, .5), 30), .4);
    leaf.respiration = 1.5;
    EXPECT_DOUBLE_EQ(dark_respiration(LeafRates(leaf), 30), 1.5);
    EXPECT_DOUBLE_EQ(dark_respiration(scaled(leaf, .5), 30), .75);
    const LeafRates collatz = CollatzLeaf{};
    EXPECT_DOUBLE_EQ(dark_respiration(scaled(collatz, .5), 25), .4);
}

TEST(Leaf, ScaledCapacityIsTheLimit) {
    EXPECT_NEAR(gross_assimilation(scaled(HyperbolaLeaf{}, .3), {}, 1e9), 15,
                1e-5);
    const Air air{25, 1};
    const double half = gross_assimilation(scaled(CollatzLeaf{}, .5), air, 1e9);
    const double full = gross_assimilation(CollatzLeaf{}, air, 1e9);
    EXPECT_NEAR(half / full, .5, .03);
}

TEST(Leaf, CollatzFollowsHumidity) {
    const LeafRates leaf = CollatzLeaf{};
    EXPECT_GT(gross_assimilation(leaf, {35, .8}, 2000),
              gross_assimilation(leaf, {35, .3}, 2000));
    EXPECT_DOUBLE_EQ(
        gross_assimilation(leaf, {25, .6}, 700),
        collatz_at({}, 25, ci_of_deficit(vapour_deficit(25, .6))).gross(700));
}

TEST(Leaf, FarquharFollowsHumidity) {
    EXPECT_GT(gross_assimilation(FarquharLeaf{}, {30, .8}, 2000),
              gross_assimilation(FarquharLeaf{}, {30, .3}, 2000));
    // The expected CO2 is 400 g1 / (g1 + sqrt(D)) with D = 1.6972 kPa.
    EXPECT_NEAR(gross_assimilation(FarquharLeaf{}, {}, 700),
                farquhar_at({}, 30, 326.53).gross(700), 1e-4);
}

//! Checks properties that all models must have.
template <class Leaf>
void expect_a_leaf() {
    const LeafRates leaf = Leaf{};
    const LeafRates half = scaled(leaf, .5);
    ASSERT_TRUE(std::holds_alternative<Leaf>(half));
    EXPECT_EQ(gross_assimilation(leaf, {}, 0), 0);
    EXPECT_LT(gross_assimilation(half, {}, 2000),
              .65 * gross_assimilation(leaf, {}, 2000));
    EXPECT_GT(dark_respiration(leaf, 20), .5);
    EXPECT_GT(dark_respiration(leaf, 30), 1.5 * dark_respiration(leaf, 20));
    EXPECT_DOUBLE_EQ(dark_respiration(half, 20),
                     dark_respiration(leaf, 20) / 2);
}

template <class... Leaves>
void expect_leaves(const std::variant<Leaves...>*) {
    (expect_a_leaf<Leaves>(), ...);
}

TEST(Leaf, OfAnyModelHasRatesAndRespires) {
    expect_leaves(static_cast<const LeafRates*>(nullptr));
}

TEST(Leaf, BuildingCostsCarbon) {
    EXPECT_NEAR(leaf_building_cost(), 2.1, .02);
}

}  // namespace
}  // namespace ideotype
