// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "handle.hpp"

namespace ideotype {

//! Text of exactly this many bytes, UTF-8, padded with NUL.
Handle string_type(std::size_t size);

//! Status, Origin and yes/no as enumerations of 8 bits. The latter is the one
//! that h5py takes for bool.
Handle status_type();
Handle origin_type();
Handle bool_type();

}  // namespace ideotype
