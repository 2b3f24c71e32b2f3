// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "ideotype/physiology/hyperbola.hpp"

namespace ideotype {

//! Expects that an expansion agrees with the response in value and slope, and
//! in the curvature computed from differences of the slope.
template <class Response>
void expect_derivatives(const Response& f) {
    EXPECT_EQ(f.expand(0).value, 0);
    for (double light = 5; light < 3000; light += 5) {
        const double h = 1e-2;
        const Expansion at = f.expand(light);
        EXPECT_EQ(at.value, f.gross(light));
        EXPECT_NEAR(at.slope, f.slope(light), 1e-14);
        EXPECT_NEAR(at.curvature,
                    (f.slope(light + h) - f.slope(light - h)) / (2 * h), 1e-9);
        EXPECT_LT(at.curvature, 0);
    }
}

//! Expects that a response begins at 0, with its quantum yield as the initial
//! slope, and that the slope then decreases.
inline void expect_concave(const Colimitation& f) {
    EXPECT_EQ(f.gross(0), 0);
    EXPECT_EQ(f.slope(0), f.alpha);
    double before = f.slope(0);
    for (double light = 5; light < 3000; light += 5) {
        const double h = 1e-3;
        EXPECT_NEAR(f.slope(light),
                    (f.gross(light + h) - f.gross(light - h)) / (2 * h), 1e-9);
        EXPECT_LT(f.slope(light), before);
        before = f.slope(light);
    }
}

}  // namespace ideotype
