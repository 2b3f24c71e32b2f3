// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/estimate.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace ideotype {

double average(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.) /
           static_cast<double>(values.size());
}

Estimate estimate(std::span<const double> values) {
    const auto n = static_cast<double>(values.size());
    const double mean = average(values);
    if (values.size() < 2)
        return {mean, std::numeric_limits<double>::quiet_NaN()};
    double squares = 0;
    for (const double x : values) squares += (x - mean) * (x - mean);
    return {mean, std::sqrt(squares / (n * (n - 1)))};
}

namespace {

//! Returns the standard error of b - factor * a, paired if possible.
double estimate_error(const Randomisations& a, const Randomisations& b,
                      double factor) {
    const std::size_t count = a.values.size();
    const bool is_paired = count > 1 && count == b.values.size() &&
                           !std::isnan(a.values.front()) &&
                           !std::isnan(b.values.front());
    if (!is_paired)
        return std::hypot(factor * a.figure.standard_error,
                          b.figure.standard_error);
    std::vector<double> differences;
    for (std::size_t i = 0; i < count; ++i)
        differences.push_back(b.values[i] - factor * a.values[i]);
    return estimate(differences).standard_error;
}

}  // namespace

Estimate difference(const Randomisations& a, const Randomisations& b) {
    return {b.figure.mean - a.figure.mean, estimate_error(a, b, 1)};
}

Estimate relative_gain(const Randomisations& a, const Randomisations& b) {
    const double reference = a.figure.mean;
    if (reference == 0) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan};
    }
    // To first order, the ratio r = b / a has the error of (b - r a) / a.
    const double ratio = b.figure.mean / reference;
    return {100 * (ratio - 1),
            100 * estimate_error(a, b, ratio) / std::abs(reference)};
}

}  // namespace ideotype
