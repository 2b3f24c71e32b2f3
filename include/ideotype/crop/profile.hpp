// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ideotype {

//! Returns the value at x of a smooth curve through values at equal distances
//! over [0, 1]: the cubic Hermite interpolation that is monotone between
//! neighbouring values, and so never beyond them (Fritsch and Butland 1984,
//! doi:10.1137/0905021). A single value gives a constant.
double profile(const std::vector<double>& values, double x);

}  // namespace ideotype
