// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ideotype {

//! Returns the leaf area index above the middle of each leaf: the sum over all
//! higher leaves plus half of the leaf's own.
//! @param leaf_area_index by leaf, the lowest first [m2 m-2 of ground]
std::vector<double> depth_of_leaves(const std::vector<double>& leaf_area_index);

//! Returns the capacity of each leaf relative to a leaf at the top of the
//! canopy: exp(-kn L), where L is the depth of the leaf.
//! @param kn coefficient per unit of leaf area index: 0.25, half the light
//! extinction coefficient, as in 393 canopies (Hikosaka et al. 2016,
//! doi:10.1093/aob/mcw099)
std::vector<double> exponential_profile(
    const std::vector<double>& leaf_area_index, double kn = 0.25);

//! The nitrogen of a canopy, a total that does not depend on its leaf area.
struct CanopyNitrogen {
    //! Nitrogen of all leaves [g m-2 of ground]. This is an estimate: 1.3 g m-2
    //! of leaf (DCaPST) at a leaf area index of 3.4.
    double total = 4.5;
    double kn = 0.25;  //!< as in exponential_profile()
};

//! Returns the nitrogen of each leaf [g m-2 of leaf]. It decreases with depth
//! as exp(-kn L); its integral over leaf area is the total.
//! @param leaf_area_index by leaf, the lowest first [m2 m-2 of ground]
std::vector<double> nitrogen_of_leaves(
    const std::vector<double>& leaf_area_index,
    const CanopyNitrogen& canopy = {});

//! Returns the capacity of a leaf with nitrogen N [g m-2] relative to a leaf
//! with 1.8 g m-2: k(N) / k(1.8) with k = 2 / (1 + e^{-2.9 (N - 0.25)}) - 1,
//! but at least 0 (Vos et al. 2005, Field Crops Research 93, 64-73).
double nitrogen_response(double nitrogen);

}  // namespace ideotype
