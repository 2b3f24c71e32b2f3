// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ideotype {

//! Returns the leaf area index above the middle of each leaf: that of all
//! higher leaves and half of that leaf's.
//! @param leaf_area_index of each leaf, the lowest first [m2 m-2 of ground]
std::vector<double> depth_of_leaves(const std::vector<double>& leaf_area_index);

//! Returns the capacity of each leaf over that of a leaf at the top, exp(-kn
//! L), where L is the depth of the leaf.
//! @param kn per leaf area index: 0.25, half the coefficient of the light, as
//! in 393 canopies (Hikosaka et al. 2016, doi:10.1093/aob/mcw099)
std::vector<double> exponential_profile(
    const std::vector<double>& leaf_area_index, double kn = 0.25);

//! The nitrogen of a canopy, which does not depend on its leaf area.
struct CanopyNitrogen {
    //! Nitrogen of all leaves [g m-2 of ground]; an estimate: 1.3 g m-2 of leaf
    //! (DCaPST) at a leaf area index of 3.4.
    double total = 4.5;
    double kn = 0.25;  //!< as of exponential_profile()
};

//! Returns the nitrogen of each leaf [g m-2 of leaf]. It falls with depth as
//! exp(-kn L), and its sum over the leaf area is the total.
//! @param leaf_area_index of each leaf, the lowest first [m2 m-2 of ground]
std::vector<double> nitrogen_of_leaves(
    const std::vector<double>& leaf_area_index,
    const CanopyNitrogen& canopy = {});

//! Returns the capacity of a leaf with some nitrogen N [g m-2] over that of a
//! leaf with 1.8 g m-2: k(N) / k(1.8) with k = 2 / (1 + e^{-2.9 (N - 0.25)}) -
//! 1 (Vos et al. 2005, Field Crops Research 93, 64-73). It is not below 0.
double nitrogen_response(double nitrogen);

}  // namespace ideotype
