// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/profile.hpp"

#include <algorithm>
#include <cmath>

namespace ideotype {

namespace {

//! Returns the slope at an inner value from the slopes on both sides.
double inner_slope(double left, double right) {
    return left * right > 0 ? 2 * left * right / (left + right) : 0;
}

//! Returns the slope at the first value: that of the parabola through three
//! values, at most three times the first slope and never against it.
double end_slope(double first, double second) {
    const double slope = (3 * first - second) / 2;
    if (slope * first <= 0) return 0;
    if (first * second <= 0 && std::abs(slope) > 3 * std::abs(first))
        return 3 * first;
    return slope;
}

}  // namespace

double profile(const std::vector<double>& values, double x) {
    const std::size_t n = values.size();
    if (n == 1) return values[0];
    const double scaled = x * static_cast<double>(n - 1);
    const auto i = std::min(static_cast<std::size_t>(scaled), n - 2);
    const double t = scaled - static_cast<double>(i);
    const auto rise = [&](std::size_t k) { return values[k + 1] - values[k]; };
    const auto slope = [&](std::size_t k) {
        if (n == 2) return rise(0);
        if (k == 0) return end_slope(rise(0), rise(1));
        if (k == n - 1) return end_slope(rise(n - 2), rise(n - 3));
        return inner_slope(rise(k - 1), rise(k));
    };
    const double a = values[i], b = values[i + 1];
    const double from = slope(i), to = slope(i + 1);
    return a + t * t * (3 - 2 * t) * (b - a) +
           t * (1 - t) * ((1 - t) * from - t * to);
}

}  // namespace ideotype
