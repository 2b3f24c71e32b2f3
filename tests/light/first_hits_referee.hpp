// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reference.hpp"

namespace ideotype {

//! Counts of the points of a beam at which the depth buffer and the ray were
//! compared.
struct FirstHitsCompared {
    std::string name;
    std::size_t points = 0;
    std::size_t differ = 0;  //!< points at which group, side or height differ
    std::size_t wrong = 0;   //!< differing points where the buffer is wrong
};

//! Compares depth buffer and ray for all reference meshes and for extreme
//! meshes, at solar elevations from 0.01 to 90 deg.
//! @param points approximate number of points of each lattice
std::vector<FirstHitsCompared> compare_first_hits(int points);

}  // namespace ideotype
