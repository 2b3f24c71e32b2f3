// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reference.hpp"

namespace ideotype {

//! The surfaces that depth buffer and rays see at the same points of a beam.
struct FirstHitsCompared {
    std::string name;
    std::size_t points = 0;
    std::size_t differ = 0;  //!< in group, side or height
    std::size_t wrong = 0;   //!< of these in the depth buffer, exactly seen
};

//! Every reference mesh and meshes at the limits, under suns from .01 to 90
//! deg.
//! @param points of each lattice, about
std::vector<FirstHitsCompared> compare_first_hits(int points);

}  // namespace ideotype
