// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/depth.hpp"

#include <algorithm>
#include <cmath>

namespace ideotype {

std::vector<double> depth_of_leaves(
    const std::vector<double>& leaf_area_index) {
    std::vector<double> depth(leaf_area_index.size());
    double above = 0;
    for (std::size_t leaf = depth.size(); leaf-- > 0;) {
        depth[leaf] = above + leaf_area_index[leaf] / 2;
        above += leaf_area_index[leaf];
    }
    return depth;
}

std::vector<double> exponential_profile(
    const std::vector<double>& leaf_area_index, double kn) {
    std::vector<double> profile = depth_of_leaves(leaf_area_index);
    for (double& value : profile) value = std::exp(-kn * value);
    return profile;
}

std::vector<double> nitrogen_of_leaves(
    const std::vector<double>& leaf_area_index, const CanopyNitrogen& canopy) {
    std::vector<double> nitrogen =
        exponential_profile(leaf_area_index, canopy.kn);
    double sum = 0;
    for (std::size_t leaf = 0; leaf < nitrogen.size(); ++leaf)
        sum += nitrogen[leaf] * leaf_area_index[leaf];
    for (double& value : nitrogen) value *= sum > 0 ? canopy.total / sum : 0;
    return nitrogen;
}

double nitrogen_response(double nitrogen) {
    const auto k = [](double n) {
        return 2 / (1 + std::exp(-2.9 * (n - 0.25))) - 1;
    };
    return std::max(k(nitrogen) / k(1.8), 0.0);
}

}  // namespace ideotype
