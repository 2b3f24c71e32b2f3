// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ideotype {

//! Leaf area index above the middle of each leaf: of all higher leaves and
//! half of its own.
//! @param leaf_area_index of each leaf, the lowest first [m2 m-2 of ground]
std::vector<double> depth_of_leaves(const std::vector<double>& leaf_area_index);

//! exp(-kn L) of each leaf's depth L: its capacity over that of the top.
//! @param kn per leaf area index: 0.25, half the coefficient of the light, as
//! in 393 canopies (Hikosaka et al. 2016, doi:10.1093/aob/mcw099)
std::vector<double> exponential_profile(
    const std::vector<double>& leaf_area_index, double kn = 0.25);

//! A canopy that has so much nitrogen, whatever its leaf area.
struct CanopyNitrogen {
    //! Nitrogen of all leaves [g m-2 of ground]; an estimate: 1.3 g m-2 of leaf
    //! (DCaPST) at a leaf area index of 3.4.
    double total = 4.5;
    double kn = 0.25;  //!< as of exponential_profile()
};

//! Nitrogen of each leaf [g m-2 of leaf], which falls as exp(-kn L) and sums
//! to the total over the leaf area.
//! @param leaf_area_index of each leaf, the lowest first [m2 m-2 of ground]
std::vector<double> nitrogen_of_leaves(
    const std::vector<double>& leaf_area_index,
    const CanopyNitrogen& canopy = {});

//! Capacity of a leaf over that at 1.8 g m-2, by its nitrogen [g m-2]: k(N) /
//! k(1.8) with k = 2 / (1 + e^{-2.9 (N - 0.25)}) - 1 (Vos et al. 2005,
//! Field Crops Research 93, 64-73), at least 0.
double nitrogen_response(double nitrogen);

}  // namespace ideotype
