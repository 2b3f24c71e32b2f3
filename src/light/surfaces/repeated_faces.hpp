// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Returns for each face whether it has the same corners as an earlier face of
//! the mesh, in any order. Light meets only the first of such faces.
std::vector<bool> repeated_faces(const Mesh& mesh);

}  // namespace ideotype
