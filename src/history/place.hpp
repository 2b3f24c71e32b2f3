// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Is this open file the one at this path?
bool is_at(const std::string& path, int descriptor);

}  // namespace ideotype
