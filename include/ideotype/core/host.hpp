// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Name of this machine, cut to 255 bytes.
std::string host_name();

//! Cores that this process may use: those of its affinity, or of the quota of
//! its container if that is less. At least 1.
int available_cores();

}  // namespace ideotype
