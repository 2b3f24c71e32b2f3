// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/range.hpp"
#include "ideotype/crop/growth.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! The numbers that a trait has: one per leaf, one for the whole plant, or the
//! points of a smooth curve over leaf position.
enum class TraitNumbers { leaf, plant, profile };

//! The effect of a trait's number on a measure: it is its value, multiplies it
//! or is added to it.
enum class TraitEffect { sets, scales, shifts };

//! Something of a plant that can be bred.
struct Trait {
    std::string name;
    TraitNumbers numbers = TraitNumbers::leaf;
    int points = 4;  //!< of a profile, from the lowest leaf to the highest
    TraitEffect effect = TraitEffect::sets;
    std::vector<std::string> measures;  //!< that it acts on: "leaf.length"
    std::string unit;                   //!< unit of its numbers; "1": a factor
    Range range;                        //!< range of each number
    bool is_circular = false;           //!< both ends of range are the same
    //! True if campaigns that name no trait set breed it.
    bool is_bred = true;
};

//! A kind of plant as data: what its plants have in common, what can be bred,
//! and the plant that breeding begins with.
struct Crop {
    Plant baseline;
    std::vector<Trait> traits;
    //! Bounds that its crop file has under names, for campaigns to choose.
    std::vector<std::string> rules{};
    //! Growth and ageing of its plants; none: the baseline is all that is
    //! known.
    std::optional<Growth> growth{};
};

//! One number of a trait.
struct TraitNumber {
    std::size_t trait = 0;  //!< place in Crop::traits
    int leaf = 0;           //!< rank from the lowest, 1; 0: not of one leaf
    int point = 0;          //!< point of a profile, from 1; 0: none
};

//! Returns all numbers of all traits in the order of a genome: leaf by leaf the
//! traits that each leaf has, then those of the whole plant and profiles, in
//! the order of the traits.
std::vector<TraitNumber> trait_numbers(const Crop& crop);

//! Returns the numbers of the baseline: its measures, and for what scales or
//! shifts others 1 or 0.
std::vector<double> baseline_numbers(const Crop& crop);

//! Returns the plant that these numbers make of the baseline: traits act on it
//! in their order. A measure beyond its limits is moved to them.
//! @param numbers as in trait_numbers()
//! @throws Error if there are too few or too many, or a trait acts on a
//! measure that there is not.
Plant grow(const Crop& crop, const std::vector<double>& numbers);

}  // namespace ideotype
