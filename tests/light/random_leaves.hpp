// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Distributions of the angle between a leaf's normal and the vertical, all
//! even about it: spherical sin t; planophile 2 (1 + cos 2t) / pi;
//! erectophile 2 (1 - cos 2t) / pi; uniform 2 / pi; horizontal 0 (de Wit
//! 1965; Goel and Strebel 1984).
enum class LeafAngles {
    spherical,
    planophile,
    erectophile,
    uniform,
    horizontal
};

//! Returns square leaves of 2 cm at independent places over a period of 1 x 1
//! m, a turbid medium but for the size of the leaves. The angles are an even
//! sample of their distribution, so that two realisations differ in places
//! only.
//! @param height of the stand [m]. In a higher stand, less of the light that a
//! leaf scatters leaves through the gap by which it came.
Mesh random_leaves(LeafAngles angles, double lai, double height,
                   std::uint64_t realisation);

}  // namespace ideotype
