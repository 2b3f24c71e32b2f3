// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/physiology/depth.hpp"
#include "ideotype/physiology/leaf.hpp"

namespace ideotype {

//! The variation of leaf capacity with position in the canopy.
enum class CapacityProfile {
    none,         //!< as specified by the rates
    exponential,  //!< exp(-kn L), with L the leaf area index above the leaf
    nitrogen,     //!< a fixed canopy nitrogen, distributed as exp(-kn L)
    rank,         //!< a function of relative leaf rank
};

//! The photosynthesis of the leaves of a canopy.
struct Photosynthesis {
    //! Rates common to all leaves, or rates of each leaf, the lowest first.
    std::vector<LeafRates> rates{HyperbolaLeaf{}};
    CapacityProfile profile = CapacityProfile::exponential;
    //! Its kn also applies to CapacityProfile::exponential.
    CanopyNitrogen nitrogen{};
    //! Capacity relative to the rates, at equal steps from the lowest leaf to
    //! the highest, with linear interpolation; for CapacityProfile::rank.
    std::vector<double> rank_capacity{1};
    //! Whether leaves use the temperature and humidity of the weather. If not,
    //! they use the air of clear days.
    bool follows_weather = true;
    double leaf_mass = 45;      //!< dry mass [g m-2 of leaf]
    double building_days = 62;  //!< days over which leaves are built
    //! Photons per unit of irradiance [umol J-1]; 1 if the unit is umol m-2
    //! s-1.
    double photons = 4.57;
};

//! Returns the rates of each leaf of a canopy, the lowest first.
//! @param leaf_area_index by leaf [m2 m-2 of ground]
//! @throws Error if the number of rates differs from the number of leaves.
std::vector<LeafRates> rates_of_leaves(
    const Photosynthesis& photosynthesis,
    const std::vector<double>& leaf_area_index);

}  // namespace ideotype
