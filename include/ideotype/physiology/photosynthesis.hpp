// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/physiology/depth.hpp"
#include "ideotype/physiology/leaf.hpp"

namespace ideotype {

//! The change of leaves' capacity with their place in the canopy.
enum class CapacityProfile {
    none,         //!< as the rates say
    exponential,  //!< exp(-kn L) of the leaf area index L above
    nitrogen,     //!< by a fixed canopy nitrogen, spread as exp(-kn L)
    rank,         //!< by the place of the leaf between the lowest and highest
};

//! The photosynthesis of the leaves of a canopy.
struct Photosynthesis {
    //! Rates of all leaves; or of each, the lowest first.
    std::vector<LeafRates> rates{HyperbolaLeaf{}};
    CapacityProfile profile = CapacityProfile::exponential;
    CanopyNitrogen nitrogen{};  //!< its kn is that of either profile
    //! Capacity over that of the rates, at equal distances from the lowest leaf
    //! to the highest and linear in between; for CapacityProfile::rank.
    std::vector<double> rank_capacity{1};
    //! True if leaves have the temperature and humidity of the weather; else
    //! their air is that of clear days.
    bool follows_weather = true;
    double leaf_mass = 45;      //!< dry mass [g m-2 of leaf]
    double building_days = 62;  //!< days over which leaves are built
    //! Photons in the unit of irradiance [umol J-1]; 1 if that is umol m-2 s-1.
    double photons = 4.57;
};

//! Returns the rates of each leaf of a canopy, the lowest first.
//! @param leaf_area_index of each leaf [m2 m-2 of ground]
//! @throws Error if there are rates of another number of leaves.
std::vector<LeafRates> rates_of_leaves(
    const Photosynthesis& photosynthesis,
    const std::vector<double>& leaf_area_index);

}  // namespace ideotype
