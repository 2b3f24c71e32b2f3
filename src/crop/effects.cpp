// SPDX-License-Identifier: Apache-2.0
#include "effects.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

MeasureInfo require_measure(Plant& plant, const std::string& name) {
    const std::optional<MeasureInfo> measure = find_measure(plant, name);
    if (!measure)
        throw Error(fmt::format("plants have no measure named {}", name));
    return *measure;
}

double relative_position(std::size_t leaf, std::size_t leaves) {
    return leaves < 2
               ? 0
               : static_cast<double>(leaf) / static_cast<double>(leaves - 1);
}

void act(TraitEffect effect, double number, const MeasureInfo& measure,
         double& value) {
    switch (effect) {
        case TraitEffect::sets:
            value = number;
            return;
        case TraitEffect::scales:
            value *= number;
            break;
        case TraitEffect::shifts:
            value += number;
            break;
    }
    if (!measure.is_direction)
        value = std::clamp(value, measure.limits.lower, measure.limits.upper);
}

}  // namespace ideotype
