// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Name of this machine, cut to 255 bytes.
std::string host_name();

}  // namespace ideotype
