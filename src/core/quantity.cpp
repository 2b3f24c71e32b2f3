// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/quantity.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace ideotype {

Axis counted(const std::string& name, const std::string& meaning,
             std::size_t size, std::int64_t first) {
    std::vector<std::int64_t> numbers(size);
    std::iota(numbers.begin(), numbers.end(), first);
    return {name, "1", meaning, std::move(numbers)};
}

const Axis& QuantitySet::axis(const std::string& name) const {
    for (const Axis& candidate : axes)
        if (candidate.name == name) return candidate;
    throw std::out_of_range("there is no axis " + name);
}

bool QuantitySet::has(const std::string& quantity) const {
    return std::any_of(
        quantities.begin(), quantities.end(),
        [&](const Quantity& candidate) { return candidate.name == quantity; });
}

std::size_t QuantitySet::size(const Quantity& quantity) const {
    std::size_t numbers = 1;
    for (const std::string& name : quantity.axes) numbers *= axis(name).size();
    return numbers;
}

std::size_t QuantitySet::size() const {
    std::size_t numbers = 0;
    for (const Quantity& quantity : quantities) numbers += size(quantity);
    return numbers;
}

std::size_t QuantitySet::offset(const std::string& name) const {
    std::size_t numbers = 0;
    for (const Quantity& quantity : quantities) {
        if (quantity.name == name) return numbers;
        numbers += size(quantity);
    }
    throw std::out_of_range("there is no quantity " + name);
}

bool has_same_axes(const Quantity& quantity, const QuantitySet& first,
                   const QuantitySet& second) {
    const auto namesake = std::find_if(
        second.quantities.begin(), second.quantities.end(),
        [&](const Quantity& other) { return other.name == quantity.name; });
    return namesake != second.quantities.end() &&
           namesake->axes == quantity.axes &&
           std::all_of(quantity.axes.begin(), quantity.axes.end(),
                       [&](const std::string& axis) {
                           return first.axis(axis).coordinates ==
                                  second.axis(axis).coordinates;
                       });
}

}  // namespace ideotype
