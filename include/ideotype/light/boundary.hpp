// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! Tells how a canopy goes on beyond its mesh: in copies without end, or not at
//! all, on an infinite plane of soil.
enum class Boundary { periodic, isolated };

}  // namespace ideotype
