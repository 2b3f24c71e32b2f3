// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! The surroundings of a mesh: infinitely many copies of the mesh, or only an
//! infinite plane of soil.
enum class Boundary { periodic, isolated };

}  // namespace ideotype
