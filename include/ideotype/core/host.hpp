// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Returns the name of this machine, cut to 255 bytes.
std::string host_name();

//! Returns the number of cores available to this process, at least 1: the
//! smaller of its CPU affinity and its container quota.
int available_cores();

//! Returns a hash, as 16 hexadecimal digits, of sin, exp, pow and other C
//! library functions at thousands of fixed arguments. The last bits of these
//! functions, and hence of results, differ between library versions and between
//! variants for processors with and without fused multiply-add.
const std::string& maths_fingerprint();

}  // namespace ideotype
