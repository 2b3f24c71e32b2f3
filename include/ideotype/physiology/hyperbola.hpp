// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace ideotype {

//! Returns q times the distance between the two roots x of the equation of
//! smooth_minimum(), without subtracting large numbers.
inline double discriminant_root(double curvature, double a, double b) {
    return std::sqrt((a - b) * (a - b) + 4 * (1 - curvature) * a * b);
}

//! Returns the smaller root x of q x^2 - (a + b) x + a b = 0: a smooth minimum
//! of a and b, neither of which may be negative. The curvature q ranges from 0,
//! where x is a b / (a + b), to 1, where x is the minimum of a and b. The root
//! is exact to rounding at both limits.
inline double smooth_minimum(double curvature, double a, double b) {
    // There is no branch for a = b = 0, so that compilers can vectorise loops.
    const double sum = a + b + discriminant_root(curvature, a, b);
    return 2 * a * b / std::max(sum, std::numeric_limits<double>::min());
}

//! Returns the derivative of smooth_minimum() with respect to a. It is 1 at
//! a = 0 if b is above 0, and 0 if a and b are 0.
double smooth_minimum_slope(double curvature, double a, double b);

//! The value of a function at a point, with its first two derivatives.
struct Expansion {
    double value, slope, curvature;
};

//! Returns smooth_minimum() with its derivatives with respect to a. At the kink
//! (q is 1 and a is b) the slope may be any number from 0 to 1. The equation
//! gives x' (2 q x - a - b) = x - b and x'' (2 q x - a - b) = 2 x' (1 - q x'),
//! where the bracket is minus discriminant_root().
inline Expansion expand_smooth_minimum(double curvature, double a, double b) {
    constexpr double least = std::numeric_limits<double>::min();
    const double root = discriminant_root(curvature, a, b);
    const double x = 2 * a * b / std::max(a + b + root, least);
    const double per_root = 1 / std::max(root, 1e-12 * (a + b) + least);
    // std::clamp() would be a branch and prevent the vectorisation of loops.
    const double slope = std::min(std::max((b - x) * per_root, 0.), 1.);
    return {x, slope, -2 * slope * (1 - curvature * slope) * per_root};
}

//! Gross assimilation of a leaf by the non-rectangular hyperbola
//!
//!     f(I) = [phi I + A - sqrt((phi I + A)^2 - 4 theta phi I A)] / (2 theta)
//!
//! (Rabinowitch 1951; Thornley 1976). It is concave in I, with f(0) = 0, f'(0)
//! = phi and the limit A.
struct Hyperbola {
    //! Quantum yield [mol CO2 per mol of absorbed photons]: 0.060, from the
    //! range of 0.055 to 0.069 in C4 grasses (Ehleringer and Pearcy 1983,
    //! doi:10.1104/pp.73.3.555: 0.065 in the subtype of maize).
    double phi = 0.060;
    //! Curvature [-], 0 to 1: 0.7 (von Caemmerer 2021,
    //! doi:10.1093/jxb/erab266), from the range of 0.5 to 0.83 in models of
    //! maize.
    double theta = 0.7;
    //! Asymptote of assimilation in strong light [umol m-2 s-1]: 50, the value
    //! of Collatz et al. 1992 (39 at 25 deg C) at 30 deg C. At an absorbed PPFD
    //! of 2000 the leaf then assimilates 42.9; use amax_for() to start from a
    //! measured rate.
    double amax = 50;

    //! Returns the gross assimilation of CO2 per leaf area [umol m-2 s-1].
    //! @param absorbed PPFD absorbed by both faces per leaf area [umol m-2 s-1]
    double gross(double absorbed) const {
        return smooth_minimum(theta, phi * absorbed, amax);
    }

    //! Returns the `amax` with which leaves of this phi and theta reach a gross
    //! assimilation f at an absorbed PPFD I [umol m-2 s-1]. The equation of the
    //! hyperbola, theta f^2 - (phi I + A) f + phi I A = 0, is linear in A, so
    //! that A = f (phi I - theta f) / (phi I - f).
    //! @param gross gross assimilation, less than phi I
    double amax_for(double absorbed, double gross) const;

    //! Returns the derivative of gross() [mol mol-1].
    double slope(double absorbed) const;

    //! Returns gross() with both derivatives.
    Expansion expand(double absorbed) const {
        const auto [value, slope, curvature] =
            expand_smooth_minimum(theta, phi * absorbed, amax);
        return {value, phi * slope, phi * phi * curvature};
    }
};

//! Gross assimilation A of a leaf with two nested smooth minima: M of the light
//! and capacity limits, and A of M and a limit L that does not depend on light:
//!
//!     theta M^2 - (V + alpha I) M + V alpha I = 0
//!     beta A^2 - (M + L) A + M L = 0        (smaller roots)
//!
//! A is concave in I and 0 at I = 0.
struct Colimitation {
    //! Quantum yield [mol CO2 per mol of absorbed photons].
    double alpha;
    double capacity;  //!< V [umol m-2 s-1]
    double theta;     //!< curvature between light and capacity [-]
    double beta;      //!< curvature between M and L [-]
    double limit;     //!< L [umol m-2 s-1]

    //! Returns the gross assimilation of CO2 per leaf area [umol m-2 s-1].
    //! @param absorbed PPFD absorbed by both faces per leaf area [umol m-2 s-1]
    double gross(double absorbed) const {
        const double lit = smooth_minimum(theta, alpha * absorbed, capacity);
        return smooth_minimum(beta, lit, limit);
    }

    //! Returns the derivative of gross() [mol mol-1].
    double slope(double absorbed) const;

    //! Returns gross() with both derivatives.
    Expansion expand(double absorbed) const {
        const Expansion lit =
            expand_smooth_minimum(theta, alpha * absorbed, capacity);
        const Expansion of = expand_smooth_minimum(beta, lit.value, limit);
        return {of.value, alpha * of.slope * lit.slope,
                alpha * alpha *
                    (of.curvature * lit.slope * lit.slope +
                     of.slope * lit.curvature)};
    }
};

}  // namespace ideotype
