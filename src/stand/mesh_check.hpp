// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/request.hpp"

namespace ideotype {

//! Checks whether light can be traced in copies of a mesh on some ground.
//! @return warnings about faults that do not prevent tracing
//! @throws Error if light cannot be traced.
std::vector<std::string> check_mesh(const Mesh& mesh, double plants,
                                    const Cell& cell);

}  // namespace ideotype
