// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Distributions of the angle t between the normal of a leaf and the vertical,
//! with uniform azimuth: spherical sin t; planophile 2 (1 + cos 2t) / pi;
//! erectophile 2 (1 - cos 2t) / pi; uniform 2 / pi; horizontal 0 (de Wit 1965;
//! Goel and Strebel 1984).
enum class LeafAngles {
    spherical,
    planophile,
    erectophile,
    uniform,
    horizontal
};

//! Returns square leaves of 2 cm at independent random positions over a period
//! of 1 x 1 m: a turbid medium, except for the size of the leaves. The leaf
//! angles are a stratified sample of their distribution, so that two
//! realisations differ only in positions.
//! @param height of the stand [m]. In a higher stand, less of the light
//! scattered by a leaf escapes through the gap through which it arrived.
Mesh random_leaves(LeafAngles angles, double lai, double height,
                   std::uint64_t realisation);

}  // namespace ideotype
