// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <type_traits>
#include <vector>

namespace ideotype {

//! Applies a function, or reads a member, for each item of a list and returns
//! the results.
template <class Items, class Function>
auto mapped(const Items& items, const Function& function) {
    using Result =
        std::invoke_result_t<const Function&, decltype(*items.begin())>;
    std::vector<std::decay_t<Result>> results;
    results.reserve(items.size());
    for (const auto& item : items)
        results.push_back(std::invoke(function, item));
    return results;
}

}  // namespace ideotype
