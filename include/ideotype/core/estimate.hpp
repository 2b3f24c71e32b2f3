// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! A value and its standard error, in the same unit.
struct Estimate {
    double mean = 0;
    double standard_error = 0;
};

//! Half-width of the 95 % confidence interval of a normal variable, in standard
//! errors.
inline constexpr double normal_95 = 1.96;

//! Returns the mean of values; NaN if there are none.
double average(std::span<const double> values);

//! Estimates the mean of independent values and its standard error, sqrt(sum (x
//! - mean)^2 / (n (n - 1))). The standard error of a single value is NaN.
Estimate estimate(std::span<const double> values);

//! An estimate with its values by randomisation, if known.
struct Randomisations {
    Estimate figure;
    std::span<const double> values;
};

//! Returns b - a. If both share their randomisations, the error is the paired
//! standard error over randomisations. Otherwise it is the error for
//! independent estimates, which overestimates it at most.
Estimate difference(const Randomisations& a, const Randomisations& b);

//! Returns the gain 100 (b / a - 1) [%], with the standard error of the ratio
//! to first order, paired as in difference(). Both are NaN if a is zero.
Estimate relative_gain(const Randomisations& a, const Randomisations& b);

//! Returns a * x for an exact factor a.
inline Estimate scaled(Estimate x, double a) {
    return {a * x.mean, (a < 0 ? -a : a) * x.standard_error};
}

//! Returns a part of the incident light relative to the incident light; 0 if
//! that is 0.
template <class Light>
Light fraction_of(Light part, double incident) {
    IDEOTYPE_EXPECT(!(incident < 0));
    return scaled(std::move(part), incident > 0 ? 1 / incident : 0);
}

}  // namespace ideotype
