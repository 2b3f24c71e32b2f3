// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reference.hpp"

namespace ideotype {

//! Counts of points of a beam at which the surfaces that depth buffer and ray
//! see were compared.
struct FirstHitsCompared {
    std::string name;
    std::size_t points = 0;
    std::size_t differ = 0;  //!< points at which group, side or height differ
    std::size_t wrong = 0;   //!< differing points where the buffer is wrong
};

//! Compares every reference mesh and meshes at the limits, under suns from 0.01
//! to 90 deg.
//! @param points about the number of points of each lattice
std::vector<FirstHitsCompared> compare_first_hits(int points);

}  // namespace ideotype
