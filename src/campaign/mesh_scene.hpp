// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "spec/mesh_spec.hpp"

namespace ideotype {

//! Reads a scene file.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
MeshScene read_mesh_scene(const std::string& path);

}  // namespace ideotype
