// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! The surroundings of a mesh: copies of the mesh without end, or nothing but
//! an infinite plane of soil.
enum class Boundary { periodic, isolated };

}  // namespace ideotype
