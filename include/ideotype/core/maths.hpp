// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! A hash of what the C library's functions that results depend on (sin, exp,
//! pow and the like) give for thousands of fixed arguments, as 16 hexadecimal
//! digits. Their last bits differ between versions of the library and between
//! its variants for processors with and without fused multiply-add.
const std::string& maths_fingerprint();

}  // namespace ideotype
