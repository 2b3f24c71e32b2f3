#include "ideotype/physiology/hyperbola.hpp"

#include <cmath>

namespace ideotype {

namespace {

//! Half the distance of the roots times the curvature, squared: without the
//! difference of large numbers.
double discriminant(double curvature, double a, double b) {
    return (a - b) * (a - b) + 4 * (1 - curvature) * a * b;
}

}  // namespace

double smooth_minimum(double curvature, double a, double b) {
    if (a == 0 || b == 0) return 0;
    return 2 * a * b / (a + b + std::sqrt(discriminant(curvature, a, b)));
}

double smooth_minimum_slope(double curvature, double a, double b) {
    if (b == 0) return 0;
    const double root = std::sqrt(discriminant(curvature, a, b));
    // From the equation: x' (2 q x - a - b) = x - b, where the bracket is
    // minus the root.
    const double x = smooth_minimum(curvature, a, b);
    if (root == 0) return 0.5;  // a kink: q is 1 and a is b
    return (b - x) / root;
}

double Hyperbola::gross(double absorbed) const {
    return smooth_minimum(theta, phi * absorbed, amax);
}

double Hyperbola::slope(double absorbed) const {
    return phi * smooth_minimum_slope(theta, phi * absorbed, amax);
}

}  // namespace ideotype
