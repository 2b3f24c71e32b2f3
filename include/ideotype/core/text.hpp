// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! The start of a text that fits into this many bytes, cut between two UTF-8
//! characters.
std::string first_bytes(const std::string& text, std::size_t size);

}  // namespace ideotype
