// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Returns the name of this machine, cut to 255 bytes.
std::string host_name();

//! Returns the number of cores available to this process: the smaller of its
//! affinity and the quota of its container, at least 1.
int available_cores();

//! Returns a hash, as 16 hexadecimal digits, of sin, exp, pow and other
//! functions of the C library at thousands of fixed arguments. The last bits of
//! these functions, and so of results, differ between versions of the library
//! and between its variants for processors with and without fused multiply-add.
const std::string& maths_fingerprint();

}  // namespace ideotype
