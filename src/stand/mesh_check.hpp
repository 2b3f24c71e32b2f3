// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/request.hpp"

namespace ideotype {

//! Checks whether a mesh that stands so often on some ground can be traced.
//! @return warnings
//! @throws Error if it cannot.
std::vector<std::string> check_mesh(const Mesh& mesh, double plants,
                                    const Cell& cell);

}  // namespace ideotype
