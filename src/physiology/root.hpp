// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace ideotype {

//! A point of a continuous function.
struct Point {
    double x, value;
};

//! Returns the point between two others where a function changes from negative
//! to not negative, to a tolerance. The ITP method (Oliveira and Takahashi
//! 2021, doi:10.1145/3423597) takes at most one step more than bisection.
template <class Function>
double root(const Function& f, Point low, Point high, double tolerance) {
    const double range = high.x - low.x;
    double slack = tolerance;
    while (slack < range) slack *= 2;
    while (high.x - low.x > 2 * tolerance) {
        const double half = (high.x - low.x) / 2;
        const double middle = low.x + half;
        const double secant = (high.value * low.x - low.value * high.x) /
                              (high.value - low.value);
        const double towards = middle < secant ? -1 : 1;
        const double least = 0.2 / range * 4 * half * half;
        const double apart = std::abs(middle - secant);
        const double away =
            std::clamp(apart - least, 0.0, std::max(slack - half, 0.0));
        double x = middle - towards * away;
        slack /= 2;
        if (x <= low.x || x >= high.x) x = middle;
        if (x <= low.x || x >= high.x) break;
        const double value = f(x);
        if (value == 0) return x;
        (value < 0 ? low : high) = {x, value};
    }
    return (low.x + high.x) / 2;
}

//! Returns root() between two points, for a function that does not decrease.
template <class Function>
double root(const Function& f, double low, double high, double tolerance) {
    const Point first{low, f(low)}, last{high, f(high)};
    if (first.value >= 0) return low;
    if (last.value <= 0) return high;
    return root(f, first, last, tolerance);
}

}  // namespace ideotype
