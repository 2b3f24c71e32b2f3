// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Returns an order of the points of a scene in which neighbours are close
//! together. The cell or plot is divided into blocks, a few per point, which
//! are visited in Morton order.
std::vector<std::uint32_t> order_by_place(
    const RayScene& scene, const std::vector<glm::dvec3>& points);

}  // namespace ideotype
