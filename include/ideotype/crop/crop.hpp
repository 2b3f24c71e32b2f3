// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/range.hpp"
#include "ideotype/crop/growth.hpp"
#include "ideotype/crop/plant.hpp"
#include "ideotype/crop/plant_variation.hpp"

namespace ideotype {

//! The numbers that a trait has: one per leaf, one for the whole plant, or the
//! points of a smooth curve over leaf position.
enum class TraitNumbers { leaf, plant, profile };

//! The effect of a trait's number on a measure: the number replaces the
//! measure, multiplies it or is added to it.
enum class TraitEffect { sets, scales, shifts };

//! A property of a plant that can be bred.
struct Trait {
    std::string name;
    TraitNumbers numbers = TraitNumbers::leaf;
    int points = 4;  //!< points of a profile, lowest leaf to highest
    TraitEffect effect = TraitEffect::sets;
    std::vector<std::string> measures;  //!< measures to act on: "leaf.length"
    std::string unit;                   //!< unit of its numbers; "1": a factor
    Range range;                        //!< range of each number
    bool is_circular = false;  //!< whether range ends meet, as angles do
    //! Whether campaigns that name no trait set breed the trait.
    bool is_bred = true;
};

//! The differences between plants of a crop in a field, as the crop file has
//! them.
struct CropVariation {
    PlantVariation plants;
    //! Largest random turn of each plant [deg]; none: that of other crops.
    std::optional<double> jitter{};
};

//! A kind of plant as data: what its plants have in common, what can be bred,
//! and the plant that breeding begins with.
struct Crop {
    Plant baseline;
    std::vector<Trait> traits;
    //! Names of the sets of bounds in the crop file that campaigns can choose.
    std::vector<std::string> rules{};
    //! Growth and ageing of plants; none: only the baseline is known.
    std::optional<Growth> growth{};
    //! Differences between plants, which only new campaigns use; none: they
    //! are unknown.
    std::optional<CropVariation> variation{};
};

//! One number of a trait.
struct TraitNumber {
    std::size_t trait = 0;  //!< place in Crop::traits
    int leaf = 0;           //!< rank from the lowest, 1; 0: no single leaf
    int point = 0;          //!< point of a profile, from 1; 0: none
};

//! Returns all numbers of all traits in the order of a genome: for each leaf
//! the traits that have a number per leaf, then the numbers of whole-plant
//! traits and profiles, in the order of the traits.
std::vector<TraitNumber> trait_numbers(const Crop& crop);

//! Returns the numbers of the baseline: the measure for a trait that sets it, 1
//! for a trait that scales and 0 for a trait that shifts measures.
std::vector<double> baseline_numbers(const Crop& crop);

//! Returns the plant that numbers of traits make of the baseline; traits act in
//! their order. A measure beyond its limits is moved to the nearest limit.
//! @param numbers numbers in the order of trait_numbers()
//! @throws Error if there are too few or too many numbers, or a trait acts on a
//! measure that the plant does not have.
Plant grow(const Crop& crop, const std::vector<double>& numbers);

//! Returns the value at x of a smooth curve through values at equal distances
//! over [0, 1]: the cubic Hermite interpolation that is monotone between
//! neighbouring values, and so never beyond them (Fritsch and Butland 1984,
//! doi:10.1137/0905021). A single value gives a constant.
double profile(const std::vector<double>& values, double x);

}  // namespace ideotype
