// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "handle.hpp"

namespace ideotype {

//! What a history of format 1.x holds, as a file of this format in memory,
//! without sessions, messages and checksums. Randomisations are not known.
Handle upgraded(hid_t file);

}  // namespace ideotype
