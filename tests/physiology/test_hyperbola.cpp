// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "derivatives.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/physiology/hyperbola.hpp"

namespace ideotype {
namespace {

//! The non-rectangular hyperbola in its textbook form.
double textbook(const Hyperbola& f, double light) {
    const double sum = f.phi * light + f.amax;
    return (sum - std::sqrt(sum * sum - 4 * f.theta * f.phi * light * f.amax)) /
           (2 * f.theta);
}

TEST(Hyperbola, IsTheEquation) {
    for (const double theta : {.3, .5, .7, .83, .95})
        for (const double light : {1., 50., 400., 1000., 2500.}) {
            const Hyperbola f{.06, theta, 50};
            EXPECT_NEAR(f.gross(light), textbook(f, light), 1e-12)
                << theta << ' ' << light;
        }
    // One sheet over soil of albedo 0.2 absorbs 909.09 in light of 1000.
    EXPECT_NEAR(Hyperbola{}.gross(1000 / 1.1), 33.6839, 5e-5);
}

TEST(Hyperbola, HasLimits) {
    const Hyperbola f;
    EXPECT_EQ(f.gross(0), 0);
    EXPECT_EQ(f.slope(0), f.phi);
    EXPECT_NEAR(f.gross(1e12), 50, 1e-6);
    EXPECT_NEAR(f.slope(1e12), 0, 1e-12);
    EXPECT_EQ((Hyperbola{.06, .7, 0}.gross(800)), 0);
    EXPECT_EQ((Hyperbola{.06, .7, 0}.slope(800)), 0);
}

TEST(Hyperbola, IsRectangularWithoutCurvature) {
    for (const double light : {1., 300., 2000.}) {
        const double x = .06 * light;
        const double rectangular = x * 50 / (x + 50);
        EXPECT_NEAR((Hyperbola{.06, 0, 50}.gross(light)), rectangular, 1e-13);
        EXPECT_NEAR((Hyperbola{.06, 1e-12, 50}.gross(light)), rectangular,
                    1e-9);
        EXPECT_NEAR((Hyperbola{.06, 0, 50}.slope(light)),
                    .06 * std::pow(50 / (x + 50), 2), 1e-15);
    }
}

TEST(Hyperbola, IsTheMinimumWithFullCurvature) {
    const Hyperbola f{.06, 1, 50};
    EXPECT_DOUBLE_EQ(f.gross(500), 30);
    EXPECT_DOUBLE_EQ(f.gross(2000), 50);
    EXPECT_DOUBLE_EQ(f.slope(500), .06);
    EXPECT_DOUBLE_EQ(f.slope(2000), 0);
}

TEST(Hyperbola, ReachesARateWithTheCapacityForIt) {
    // Expected value, computed by hand: 50 (120 - 0.7 50) / (120 - 50).
    EXPECT_NEAR((Hyperbola{.06, .7}.amax_for(2000, 50)), 60.7142857, 1e-6);
    for (const double theta : {0., .5, .7, 1.})
        for (const double rate : {0., 3., 52., 119.}) {
            Hyperbola f{.06, theta};
            f.amax = f.amax_for(2000, rate);
            EXPECT_NEAR(f.gross(2000), rate, 1e-11 * (1 + f.amax))
                << theta << ' ' << rate;
        }
#ifdef IDEOTYPE_CONTRACTS
    EXPECT_THROW(Hyperbola{}.amax_for(2000, 120), ContractError);
#endif
}

TEST(Hyperbola, IsProportionalToLightWithoutSaturation) {
    const Hyperbola f{.06, .7, 1e13};
    EXPECT_NEAR(f.gross(1500), .06 * 1500, 1e-9);
}

TEST(Hyperbola, SlopeIsTheDerivativeAndFalls) {
    for (const double theta : {0., .5, .7, .95}) {
        const Hyperbola f{.06, theta, 50};
        double before = f.slope(0);
        for (double light = 5; light < 3000; light += 5) {
            const double h = 1e-3;
            const double numeric =
                (f.gross(light + h) - f.gross(light - h)) / (2 * h);
            EXPECT_NEAR(f.slope(light), numeric, 1e-10);
            EXPECT_LT(f.slope(light), before);
            before = f.slope(light);
        }
    }
}

TEST(Hyperbola, ExpandsToItsDerivatives) {
    expect_derivatives(Hyperbola{});
}

}  // namespace
}  // namespace ideotype
