// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/crop.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/measures.hpp"
#include "ideotype/crop/profile.hpp"

namespace ideotype {

namespace {

MeasureInfo measure_of(Plant& plant, const std::string& name) {
    const std::optional<MeasureInfo> found = find_measure(plant, name);
    if (!found)
        throw Error(
            fmt::format("plants have no measure that is called {}", name));
    return *found;
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

//! Returns a trait's number for each leaf of a plant.
double number_at(const Trait& trait, const std::vector<double>& numbers,
                 std::size_t leaf, std::size_t leaves) {
    switch (trait.numbers) {
        case TraitNumbers::leaf:
            return numbers.at(leaf);
        case TraitNumbers::plant:
            break;
        case TraitNumbers::profile:
            return profile(numbers, leaves < 2
                                        ? 0
                                        : static_cast<double>(leaf) /
                                              static_cast<double>(leaves - 1));
    }
    return numbers.at(0);
}

}  // namespace

std::vector<TraitNumber> trait_numbers(const Crop& crop) {
    std::vector<TraitNumber> all;
    const auto leaves = static_cast<int>(crop.baseline.leaves.size());
    for (int leaf = 1; leaf <= leaves; ++leaf)
        for (std::size_t t = 0; t < crop.traits.size(); ++t)
            if (crop.traits[t].numbers == TraitNumbers::leaf)
                all.push_back({t, leaf, 0});
    for (std::size_t t = 0; t < crop.traits.size(); ++t) {
        const Trait& trait = crop.traits[t];
        if (trait.numbers == TraitNumbers::plant) all.push_back({t, 0, 0});
        if (trait.numbers != TraitNumbers::profile) continue;
        for (int point = 1; point <= trait.points; ++point)
            all.push_back({t, 0, point});
    }
    return all;
}

std::vector<double> baseline_numbers(const Crop& crop) {
    Plant plant = crop.baseline;
    std::vector<double> numbers;
    for (const TraitNumber& number : trait_numbers(crop)) {
        const Trait& trait = crop.traits[number.trait];
        if (trait.effect != TraitEffect::sets) {
            numbers.push_back(trait.effect == TraitEffect::scales ? 1 : 0);
            continue;
        }
        const MeasureInfo measure = measure_of(plant, trait.measures.at(0));
        numbers.push_back(*measure.values.at(
            static_cast<std::size_t>(std::max(number.leaf, 1) - 1)));
    }
    return numbers;
}

Plant grow(const Crop& crop, const std::vector<double>& numbers) {
    const std::vector<TraitNumber> order = trait_numbers(crop);
    if (numbers.size() != order.size())
        throw Error(
            fmt::format("a genome of {} genes is not a plant (its "
                        "traits have {} numbers)",
                        numbers.size(), order.size()));
    std::vector<std::vector<double>> of_trait(crop.traits.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        of_trait[order[i].trait].push_back(numbers[i]);

    Plant plant = crop.baseline;
    for (std::size_t t = 0; t < crop.traits.size(); ++t) {
        const Trait& trait = crop.traits[t];
        for (const std::string& name : trait.measures) {
            const MeasureInfo measure = measure_of(plant, name);
            const std::size_t count = measure.values.size();
            for (std::size_t i = 0; i < count; ++i)
                act(trait.effect, number_at(trait, of_trait[t], i, count),
                    measure, *measure.values[i]);
        }
    }
    stack_internodes(plant);
    return plant;
}

}  // namespace ideotype
