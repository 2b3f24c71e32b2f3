// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ideotype {

//! Returns a smooth curve through values at equal distances over [0, 1], at x:
//! the cubic Hermite interpolation that is monotone between neighbouring
//! values, and so nowhere beyond them (Fritsch and Butland 1984,
//! doi:10.1137/0905021; one value is a constant).
double profile(const std::vector<double>& values, double x);

}  // namespace ideotype
