// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "derivatives.hpp"
#include "ideotype/physiology/farquhar.hpp"

namespace ideotype {
namespace {

//! The limiting rates as published.
struct Limits {
    double rubisco, transport, triose;
};

double bernacchi(double c, double energy, double temperature) {
    return std::exp(c - energy * 1000 / (8.314462618 * (temperature + 273.15)));
}

double smaller_root(double q, double a, double b) {
    return (a + b - std::sqrt((a + b) * (a + b) - 4 * q * a * b)) / (2 * q);
}

double harley(double temperature) {
    const double rt = 8.314462618e-3 * (temperature + 273.15);
    return std::exp(21.46 - 53.1 / rt) /
           (1 + std::exp((.65 * (temperature + 273.15) - 201.8) / rt));
}

Limits textbook(double light, double t, double ci) {
    const double star = bernacchi(19.02, 37.83, t);
    const double km =
        bernacchi(38.05, 79.43, t) * (1 + 210 / bernacchi(20.30, 36.38, t));
    const double vcmax =
        110 * bernacchi(26.35, 65.33, t) / bernacchi(26.35, 65.33, 25);
    const double jmax =
        195 * bernacchi(17.57, 43.5, t) / bernacchi(17.57, 43.5, 25);
    const double j =
        smaller_root(.76 + .018 * t - .00037 * t * t,
                     light * .5 * (.352 + .022 * t - .00034 * t * t), jmax);
    return {vcmax * (ci - star) / (ci + km),
            j * (ci - star) / (4.5 * ci + 10.5 * star),
            3 * 13 * harley(t) / harley(25)};
}

TEST(Farquhar, HasTheLimitsOfSoybean) {
    const Limits bright = textbook(1e9, 25, 280);
    EXPECT_NEAR(bright.rubisco, 26.2, .05);
    EXPECT_NEAR(bright.transport, 27.0, .05);
    FarquharLeaf leaf;
    leaf.jmax = leaf.tpu = 1e9;
    EXPECT_NEAR(farquhar_at(leaf, 25, 280).gross(1e12), bright.rubisco, 1e-5);
    leaf.jmax = 195;
    leaf.vcmax = 1e9;
    EXPECT_NEAR(farquhar_at(leaf, 25, 280).gross(1e12), bright.transport, 1e-5);
}

TEST(Farquhar, IsTheSmallestOfThreeLimits) {
    FarquharLeaf sharp;
    sharp.beta = 1;
    for (const double t : {10., 18., 25., 33., 40.})
        for (const double ci : {60., 150., 280., 600., 1200.})
            for (const double light : {1., 100., 400., 900., 2000.}) {
                const auto [c, j, p] = textbook(light, t, ci);
                if (c < 0) continue;
                const double least = std::min({c, j, p});
                EXPECT_NEAR(farquhar_at(sharp, t, ci).gross(light), least,
                            1e-9);
                const double found = farquhar_at({}, t, ci).gross(light);
                EXPECT_NEAR(
                    found, smaller_root(.98, j, smaller_root(.98, c, p)), 1e-9);
                // Co-limitation by two equal rates gives 0.876 of either, by
                // three 0.81.
                EXPECT_LT(found, least);
                EXPECT_GT(found, .8 * least);
            }
}

//! Expected values: independent code in another language.
TEST(Farquhar, HasTheValuesOfOtherCode) {
    const auto gross = [](double light, double temperature, double ci) {
        return farquhar_at({}, temperature, ci).gross(light);
    };
    EXPECT_NEAR(gross(100, 25, 280), 4.734027921049503, 1e-9);
    EXPECT_NEAR(gross(1500, 25, 280), 22.695190335945824, 1e-9);
    EXPECT_NEAR(gross(1500, 15, 280), 15.009431260098486, 1e-9);
    EXPECT_NEAR(gross(1500, 35, 280), 25.271045185348093, 1e-9);
    EXPECT_NEAR(gross(2000, 40, 200), 14.726376035525874, 1e-9);
    EXPECT_NEAR(dark_respiration(FarquharLeaf{}, 35), 2.3493671251880195, 1e-9);
}

TEST(Farquhar, IsConcaveFromItsQuantumYield) {
    for (const double temperature : {5., 15., 25., 40.})
        expect_concave(farquhar_at({}, temperature, 280));
    // Quantum yields of C3 leaves at 25 deg C are 0.05 to 0.06.
    EXPECT_NEAR(farquhar_at({}, 25, 280).alpha, .05, .01);
}

TEST(Farquhar, ExpandsToItsDerivatives) {
    expect_derivatives(farquhar_at({}, 25, 280));
    expect_derivatives(farquhar_at({}, 35, 250));
}

TEST(Farquhar, HasItsRatesAt25Degrees) {
    EXPECT_EQ(dark_respiration(FarquharLeaf{}, 25), 1.28);
    FarquharLeaf leaf;
    leaf.jmax = 2 * 195;
    EXPECT_EQ(farquhar_at(leaf, 25, 280).capacity,
              2 * farquhar_at({}, 25, 280).capacity);
    EXPECT_EQ(farquhar_at(leaf, 25, 280).theta, leaf.theta);
    // At this CO2 concentration, triose phosphate is the only limit.
    leaf.vcmax = leaf.jmax = 1e9;
    EXPECT_NEAR(farquhar_at(leaf, 25, 1e6).gross(1e9), 3 * 13, 1e-4);
}

TEST(Farquhar, IsFiniteAtAnyTemperature) {
    for (double temperature = -30; temperature <= 60; temperature += .5)
        for (const double ci : {0., 30., 280., 1000.}) {
            const Colimitation f = farquhar_at({}, temperature, ci);
            EXPECT_EQ(f.gross(0), 0);
            for (const double light : {1., 2000.}) {
                const auto [value, slope, curvature] = f.expand(light);
                EXPECT_TRUE(std::isfinite(value) && value >= 0) << temperature;
                EXPECT_TRUE(std::isfinite(slope) && slope >= 0) << temperature;
                EXPECT_TRUE(std::isfinite(curvature) && curvature <= 0);
            }
            EXPECT_GT(dark_respiration(FarquharLeaf{}, temperature), 0);
        }
}

TEST(Farquhar, RisesWithCo2FromTheCompensationPoint) {
    EXPECT_EQ(farquhar_at({}, 25, 42).gross(1000), 0);
    double before = 0;
    for (double ci = 44; ci < 1500; ci += 20) {
        const double gross = farquhar_at({}, 25, ci).gross(1000);
        EXPECT_GT(gross, before);
        before = gross;
    }
}

TEST(Farquhar, StomataCloseInDryAir) {
    EXPECT_DOUBLE_EQ(ci_of_optimal_stomata(1, 4), .8 * 400);
    EXPECT_DOUBLE_EQ(ci_of_optimal_stomata(4, 3, 500), .6 * 500);
    EXPECT_EQ(ci_of_optimal_stomata(0, 5), ci_of_optimal_stomata(.05, 5));
    EXPECT_EQ(ci_of_optimal_stomata(1, 0), 0);
}

}  // namespace
}  // namespace ideotype
