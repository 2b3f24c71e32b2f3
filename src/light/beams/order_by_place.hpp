// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Returns an order of points of a scene in which neighbours are near each
//! other: by blocks of the cell or the plot, a few per point, in Morton's
//! order, in which near blocks have near numbers.
std::vector<std::uint32_t> order_by_place(
    const RayScene& scene, const std::vector<glm::dvec3>& points);

}  // namespace ideotype
