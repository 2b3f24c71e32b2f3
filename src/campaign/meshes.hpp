// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "entries.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/mesh.hpp"
#include "ideotype/core/range.hpp"

namespace ideotype {

//! Returns the surfaces of an object at its place in the field.
Mesh mesh_of(const ObjectEntry& object);

//! The depth below the soil that rounding may explain [m].
inline constexpr double least_depth = 1e-3;

//! Returns the lowest and the highest corner of all faces [m].
Range heights_of(const Mesh& mesh);

//! Returns why light in copies of a mesh could not be traced in a bounded time:
//! the size of the mesh relative to the cell with which it repeats. Returns
//! nothing if it can be traced.
//! @param copies copies of the mesh in the cell
//! @return words that follow the name of the mesh
std::optional<std::string> excess_of(const Mesh& mesh, double copies,
                                     const Cell& cell);

}  // namespace ideotype
