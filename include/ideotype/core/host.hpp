// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Name of this machine, cut to 255 bytes.
std::string host_name();

//! Cores that this process may use: those of its affinity, or of the quota of
//! its container if that is less. At least 1.
int available_cores();

//! A hash of what the C library's functions that results depend on (sin, exp,
//! pow and the like) give for thousands of fixed arguments, as 16 hexadecimal
//! digits. Their last bits differ between versions of the library and between
//! its variants for processors with and without fused multiply-add.
const std::string& maths_fingerprint();

}  // namespace ideotype
