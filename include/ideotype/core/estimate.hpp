// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! A figure and its standard error, in the same unit.
struct Estimate {
    double mean = 0;
    double standard_error = 0;
};

//! Half of a 95 % confidence interval of a normal variable over its standard
//! error.
inline constexpr double normal_95 = 1.96;

//! Returns the mean of values; NaN if there are none.
double mean_of(std::span<const double> values);

//! Returns the mean of independent values and the standard error of that mean,
//! sqrt(sum (x - mean)^2 / (n (n - 1))). The standard error of a single value
//! is NaN.
Estimate estimate(std::span<const double> values);

//! A figure with its values by randomisation, if they are known.
struct Randomisations {
    Estimate figure;
    std::span<const double> values;
};

//! Returns b - a. If both share their randomisations, the standard error is
//! that of the differences by randomisation, else that of independent figures,
//! which may only be too large.
Estimate difference(const Randomisations& a, const Randomisations& b);

//! Returns 100 (b / a - 1) [%], with the standard error of the ratio to first
//! order, paired as in difference(). Both are NaN if a is zero.
Estimate relative_gain(const Randomisations& a, const Randomisations& b);

//! Returns a * x for an exact factor a.
inline Estimate scaled(Estimate x, double a) {
    return {a * x.mean, (a < 0 ? -a : a) * x.standard_error};
}

//! Returns a part of the incident light as a fraction of the incident light, or
//! 0 if that is 0.
template <class Light>
Light fraction_of(Light part, double incident) {
    IDEOTYPE_EXPECT(!(incident < 0));
    return scaled(std::move(part), incident > 0 ? 1 / incident : 0);
}

}  // namespace ideotype
