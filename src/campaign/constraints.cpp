#include <algorithm>
#include <cmath>

#include "ideotype/campaign/campaign.hpp"

namespace ideotype {

namespace {

//! By what part of the limit a value exceeds it.
double excess(double value, double limit) {
    return std::max(0.0, value - limit) / limit;
}

double step_excess(const std::vector<LeafTraits>& leaves,
                   double LeafTraits::*trait, double limit) {
    double sum = 0;
    for (std::size_t i = 1; limit > 0 && i < leaves.size(); ++i)
        sum += excess(std::abs(leaves[i].*trait - leaves[i - 1].*trait), limit);
    return sum;
}

}  // namespace

double violation(const Constraints& constraints,
                 const std::vector<LeafTraits>& leaves, double lai) {
    const auto& [bounds, length, width, insertion_angle, erect_top] =
        constraints;
    double sum = excess(lai, bounds.upper);
    if (lai < bounds.lower) sum += (bounds.lower - lai) / bounds.lower;
    sum += step_excess(leaves, &LeafTraits::length, length);
    sum += step_excess(leaves, &LeafTraits::width, width);
    sum += step_excess(leaves, &LeafTraits::insertion_angle, insertion_angle);
    for (std::size_t i = 1; erect_top && i < leaves.size(); ++i) {
        constexpr double right_angle = 90;
        sum += std::max(0.0, leaves[i].insertion_angle -
                                 leaves[i - 1].insertion_angle) /
               right_angle;
    }
    return sum;
}

}  // namespace ideotype
