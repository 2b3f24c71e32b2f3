// SPDX-License-Identifier: Apache-2.0
#include "removed_keys.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

namespace ideotype {

namespace {

//! Keys that existed up to version 0.3.1, by the ends of their names, with
//! their defaults.
constexpr std::pair<const char*, std::variant<double, std::string_view>>
    removed_keys[] = {{"stalk.leaf_base", "surface"},
                      {"search.crossover_probability", 0.9},
                      {"search.crossover_index", 15.0},
                      {"search.mutations_per_child", 1.0},
                      {"search.mutation_index", 20.0},
                      {"search.step", 0.2},
                      {"stop.failed_fraction", 0.5},
                      {"parallel.attempts", 3.0},
                      {"variation.late_size", 0.7},
                      {"water.emissivity", 0.96},
                      {"water.hot", 35.0},
                      {"blade.lateral_size", 1.0},
                      {"growth.slowest", 0.45},
                      {"growth.lower_leaves", 0.4},
                      {"organ.azimuth", 0.0}};

}  // namespace

bool has_former_default(const std::string& key, const toml::node& value) {
    return std::ranges::any_of(removed_keys, [&](const auto& removed) {
        const auto has = [&](const auto& former) {
            return value.value<std::decay_t<decltype(former)>>() == former;
        };
        return key.ends_with(removed.first) && std::visit(has, removed.second);
    });
}

}  // namespace ideotype
