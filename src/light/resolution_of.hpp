// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/light/layers.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/resolution.hpp"

namespace ideotype {

//! Returns the resolution of a scene: how much one path can change each figure,
//! and the energy of a path of each source.
Resolution resolution_of(const RayScene& scene,
                         const std::vector<Group>& groups, const Optics& optics,
                         const Layers& layers, std::vector<double> path_energy);

}  // namespace ideotype
