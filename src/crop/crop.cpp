// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/crop.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "effects.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

//! Returns the slope of the curve at an inner value: the harmonic mean of the
//! slopes on both sides, or 0 at an extremum. This keeps the curve monotone.
double inner_slope(double left, double right) {
    return left * right > 0 ? 2 * left * right / (left + right) : 0;
}

//! Returns the slope of the curve at the first value, from the parabola through
//! three values. It is limited to three times the first slope and never
//! opposite to it.
double end_slope(double first, double second) {
    const double slope = (3 * first - second) / 2;
    if (slope * first <= 0) return 0;
    if (first * second <= 0 && std::abs(slope) > 3 * std::abs(first))
        return 3 * first;
    return slope;
}

//! Selects the value of a trait that applies to a leaf.
double select_value(const Trait& trait, const std::vector<double>& numbers,
                    std::size_t leaf, std::size_t leaves) {
    switch (trait.numbers) {
        case TraitNumbers::leaf:
            return numbers.at(leaf);
        case TraitNumbers::plant:
            break;
        case TraitNumbers::profile:
            return profile(numbers, relative_position(leaf, leaves));
    }
    return numbers.at(0);
}

//! Adds the response to density that the values of a trait describe.
void add_response(const Trait& trait, const std::vector<double>& slopes,
                  Plant& plant) {
    if (std::ranges::all_of(slopes, [](double x) { return x == 0; })) return;
    DensityResponse response;
    (trait.effect == TraitEffect::scales ? response.scales : response.shifts) =
        trait.measures;
    response.slopes = slopes;
    plant.plasticity.responses.push_back(std::move(response));
}

}  // namespace

double profile(const std::vector<double>& values, double x) {
    const std::size_t n = values.size();
    if (n == 1) return values[0];
    const double scaled = x * static_cast<double>(n - 1);
    const auto i = std::min(static_cast<std::size_t>(scaled), n - 2);
    const double t = scaled - static_cast<double>(i);
    const auto rise = [&](std::size_t k) { return values[k + 1] - values[k]; };
    const auto slope = [&](std::size_t k) {
        if (n == 2) return rise(0);
        if (k == 0) return end_slope(rise(0), rise(1));
        if (k == n - 1) return end_slope(rise(n - 2), rise(n - 3));
        return inner_slope(rise(k - 1), rise(k));
    };
    // The cubic Hermite polynomial between the values a and b.
    const double a = values[i], b = values[i + 1];
    const double slope_before = slope(i), slope_after = slope(i + 1);
    return a + t * t * (3 - 2 * t) * (b - a) +
           t * (1 - t) * ((1 - t) * slope_before - t * slope_after);
}

std::vector<TraitNumber> trait_numbers(const Crop& crop) {
    std::vector<TraitNumber> numbers;
    const auto leaves = static_cast<int>(crop.baseline.leaves.size());
    for (int leaf = 1; leaf <= leaves; ++leaf)
        for (std::size_t t = 0; t < crop.traits.size(); ++t)
            if (crop.traits[t].numbers == TraitNumbers::leaf)
                numbers.push_back({t, leaf, 0});
    for (std::size_t t = 0; t < crop.traits.size(); ++t) {
        const Trait& trait = crop.traits[t];
        if (trait.numbers == TraitNumbers::plant) numbers.push_back({t, 0, 0});
        if (trait.numbers != TraitNumbers::profile) continue;
        for (int point = 1; point <= trait.points; ++point)
            numbers.push_back({t, 0, point});
    }
    return numbers;
}

std::vector<double> baseline_numbers(const Crop& crop) {
    Plant plant = crop.baseline;
    std::vector<double> numbers;
    for (const TraitNumber& number : trait_numbers(crop)) {
        const Trait& trait = crop.traits[number.trait];
        if (trait.effect != TraitEffect::sets) {
            const bool is_factor =
                trait.effect == TraitEffect::scales && !trait.is_slope;
            numbers.push_back(is_factor ? 1 : 0);
            continue;
        }
        const MeasureInfo measure =
            require_measure(plant, trait.measures.at(0));
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
    std::vector<std::vector<double>> values(crop.traits.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        values[order[i].trait].push_back(numbers[i]);

    Plant plant = crop.baseline;
    for (std::size_t t = 0; t < crop.traits.size(); ++t) {
        const Trait& trait = crop.traits[t];
        if (trait.is_slope) {
            add_response(trait, values[t], plant);
            continue;
        }
        for (const std::string& name : trait.measures)
            change(plant, name, trait.effect,
                   [&](std::size_t leaf, std::size_t leaves) {
                       return select_value(trait, values[t], leaf, leaves);
                   });
    }
    stack_internodes(plant);
    return plant;
}

}  // namespace ideotype
