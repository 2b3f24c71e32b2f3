// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/range.hpp"
#include "ideotype/crop/grain.hpp"
#include "ideotype/crop/growth.hpp"
#include "ideotype/crop/plant.hpp"
#include "ideotype/crop/plant_variation.hpp"

namespace ideotype {

//! The values of a trait: one per leaf, one for the whole plant, or the points
//! of a smooth curve over leaf position.
enum class TraitNumbers { leaf, plant, profile };

//! The effect of a trait value on a measure: it replaces the measure,
//! multiplies it or is added to it.
enum class TraitEffect { sets, scales, shifts };

//! A property of a plant that breeding can change.
struct Trait {
    std::string name;
    TraitNumbers numbers = TraitNumbers::leaf;
    int points = 4;  //!< points of a profile, lowest leaf to highest
    TraitEffect effect = TraitEffect::sets;
    std::vector<std::string> measures;  //!< measures to act on: "leaf.length"
    std::string unit;                   //!< unit of its numbers; "1": a factor
    Range range;                        //!< range of each number
    bool is_circular = false;  //!< whether range ends meet, as angles do
    //! Whether its numbers are the slopes of a reaction norm, see
    //! DensityResponse, so that the trait acts at other densities than the
    //! reference.
    bool is_slope = false;
    //! Whether campaigns without an explicit set of traits optimise this trait.
    bool is_bred = true;
};

//! Variation between plants of a crop in a field, as given in the crop file.
struct CropVariation {
    PlantVariation plants;
    //! Largest random rotation of each plant [deg]; none: the default for all
    //! crops.
    std::optional<double> jitter{};
};

//! A crop as data: the properties common to its plants, the traits that can be
//! optimised, and the plant from which optimisation starts.
struct Crop {
    Plant baseline;
    std::vector<Trait> traits;
    //! Names of the sets of bounds in the crop file that campaigns can choose.
    std::vector<std::string> rules{};
    //! Growth and ageing of plants; none: only the full-grown baseline is
    //! known.
    std::optional<Growth> growth{};
    std::optional<Grain> grain{};  //!< none: kernels are not modelled
    //! Variation between plants, used by new campaigns only; none: not known.
    std::optional<CropVariation> variation{};
};

//! One value of a trait.
struct TraitNumber {
    std::size_t trait = 0;  //!< index in Crop::traits
    int leaf = 0;           //!< rank, 1 for the lowest leaf; 0: no single leaf
    int point = 0;          //!< point of a profile, from 1; 0: none
};

//! Returns all trait values in the order of a genome. First come, leaf by leaf,
//! the traits with one value per leaf, then the values of whole-plant traits
//! and profiles in the order of the traits.
std::vector<TraitNumber> trait_numbers(const Crop& crop);

//! Returns the trait values that leave the baseline unchanged: 1 for a trait
//! that scales measures, 0 for a trait that shifts measures and for slopes of
//! reaction norms, and the baseline's own measure for a trait that sets a
//! measure.
std::vector<double> baseline_numbers(const Crop& crop);

//! Returns the baseline with these trait values. Traits are applied in order; a
//! measure beyond its limits is set to the nearest limit.
//! @param numbers trait values in the order of trait_numbers()
//! @throws Error if there are too few or too many values, or the plant lacks a
//! measure that a trait changes.
Plant grow(const Crop& crop, const std::vector<double>& numbers);

//! Interpolates values at equal distances over [0, 1] at x. The curve is cubic
//! Hermite and monotone between neighbouring values, so it never overshoots
//! them (Fritsch and Butland 1984, doi:10.1137/0905021). A single value gives a
//! constant.
double profile(const std::vector<double>& values, double x);

}  // namespace ideotype
