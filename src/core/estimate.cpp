// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/estimate.hpp"

#include <cmath>
#include <limits>

namespace ideotype {

Estimate estimate(std::span<const double> replicates) {
    const auto n = static_cast<double>(replicates.size());
    double sum = 0;
    for (const double x : replicates) sum += x;
    const double mean = sum / n;
    if (replicates.size() < 2)
        return {mean, std::numeric_limits<double>::quiet_NaN()};
    double squares = 0;
    for (const double x : replicates) squares += (x - mean) * (x - mean);
    return {mean, std::sqrt(squares / (n * (n - 1)))};
}

}  // namespace ideotype
