// SPDX-License-Identifier: Apache-2.0
#include "removed_keys.hpp"

#include <algorithm>
#include <utility>

namespace ideotype {

namespace {

//! Keys up to version 0.3.1 and their defaults, by the ends of their names.
constexpr std::pair<const char*, double> removed_keys[] = {
    {"search.crossover_probability", 0.9},
    {"search.crossover_index", 15},
    {"search.mutations_per_child", 1},
    {"search.mutation_index", 20},
    {"search.step", 0.2},
    {"stop.failed_fraction", 0.5},
    {"parallel.attempts", 3},
    {"variation.late_size", 0.7},
    {"water.emissivity", 0.96},
    {"water.hot", 35},
    {"blade.lateral_size", 1},
    {"growth.slowest", 0.45},
    {"growth.lower_leaves", 0.4},
    {"organ.azimuth", 0}};

}  // namespace

bool has_former_default(const std::string& key, const toml::node& value) {
    if (key.ends_with("stalk.leaf_base"))
        return value.value<std::string>() == "surface";
    return std::ranges::any_of(removed_keys, [&](const auto& each) {
        return key.ends_with(each.first) &&
               value.value<double>() == each.second;
    });
}

}  // namespace ideotype
