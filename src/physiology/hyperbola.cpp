// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/hyperbola.hpp"

#include "ideotype/core/contract.hpp"

namespace ideotype {

double smooth_minimum_slope(double curvature, double a, double b) {
    if (b == 0) return 0;
    const double root = discriminant_root(curvature, a, b);
    // The derivative of the equation gives x' (2 q x - a - b) = x - b, where
    // the bracket is minus the square root of the discriminant.
    const double x = smooth_minimum(curvature, a, b);
    if (root == 0) return 0.5;  // a kink: q is 1 and a is b
    return (b - x) / root;
}

double Hyperbola::amax_for(double absorbed, double gross) const {
    const double most = phi * absorbed;
    IDEOTYPE_EXPECT(gross >= 0 && gross < most);
    return gross * (most - theta * gross) / (most - gross);
}

double Hyperbola::slope(double absorbed) const {
    return phi * smooth_minimum_slope(theta, phi * absorbed, amax);
}

double Colimitation::slope(double absorbed) const {
    const double lit = smooth_minimum(theta, alpha * absorbed, capacity);
    return alpha * smooth_minimum_slope(theta, alpha * absorbed, capacity) *
           smooth_minimum_slope(beta, lit, limit);
}

}  // namespace ideotype
