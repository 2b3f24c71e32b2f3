// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Returns the name of this machine, cut to 255 bytes.
std::string host_name();

//! Returns how many cores this process may use: those of its affinity, or of
//! the quota of its container if that is less, but at least 1.
int available_cores();

//! Returns a hash, as 16 hexadecimal digits, of the values that the C library's
//! functions which results depend on (sin, exp, pow and the like) have for
//! thousands of fixed arguments. Their last bits differ between versions of the
//! library and between its variants for processors with and without fused
//! multiply-add.
const std::string& maths_fingerprint();

}  // namespace ideotype
