// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

//! Returns a measure of a plant.
//! @throws Error if the plant lacks it.
MeasureInfo require_measure(Plant& plant, const std::string& name);

//! Returns the relative position of a leaf, from 0 for the lowest to 1 for the
//! highest. The position of a single leaf is 0.
double relative_position(std::size_t leaf, std::size_t leaves);

//! Changes a value of a measure by a number, within the limits of the measure.
void act(TraitEffect effect, double number, const MeasureInfo& measure,
         double& value);

//! Changes all values of a measure of a plant.
//! @param number_of function of the index of a leaf and the number of leaves
//! that returns the number by which the value changes
//! @throws Error if the plant lacks the measure.
template <class NumberOf>
void change(Plant& plant, const std::string& name, TraitEffect effect,
            const NumberOf& number_of) {
    const MeasureInfo measure = require_measure(plant, name);
    const std::size_t count = measure.values.size();
    for (std::size_t i = 0; i < count; ++i)
        act(effect, number_of(i, count), measure, *measure.values[i]);
}

}  // namespace ideotype
