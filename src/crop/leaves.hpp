// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Returns a vector turned about the stalk: an azimuth of 0 points along the
//! row (+y), 90 across it (+x).
glm::dvec3 about_stalk(const glm::dvec3& v, double azimuth);

//! Returns the end of a leaf's petiole: its distance from the stalk's axis and
//! its height [m].
glm::dvec2 petiole_end(const Plant& plant, const Leaf& leaf);

//! Returns the end of a leaf's rachis, where the middle leaflet begins: its
//! distance from the stalk's axis and its height [m].
glm::dvec2 rachis_end(const Plant& plant, const Leaf& leaf);

//! Adds the green, visible part of the leaflets of a leaf to a group of a mesh.
void add_leaf(Mesh& mesh, std::uint32_t group, const Plant& plant,
              const Leaf& leaf, int cells_along);

//! Adds the dead part of a leaf, if any, to a group of a mesh.
void add_dead_part(Mesh& mesh, std::uint32_t group, const Plant& plant,
                   const Leaf& leaf, int cells_along);

}  // namespace ideotype
