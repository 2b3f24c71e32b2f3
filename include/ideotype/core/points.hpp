// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! Interpolates linearly between points: position 0 is the first point, 1 the
//! second. Positions beyond the last point return its value.
//! @param points at least one
//! @param position not negative
inline double value_between(std::span<const double> points, double position) {
    IDEOTYPE_EXPECT(!points.empty() && position >= 0);
    const std::size_t last = points.size() - 1;
    const std::size_t below =
        std::min(static_cast<std::size_t>(position), last);
    const std::size_t above = std::min(below + 1, last);
    return std::lerp(points[below], points[above],
                     position - static_cast<double>(below));
}

}  // namespace ideotype
