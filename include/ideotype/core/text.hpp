// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! The start of a text that fits into this many bytes, cut between two UTF-8
//! characters.
std::string first_bytes(const std::string& text, std::size_t size);

//! A text of unknown origin as one line for a terminal, where it can do
//! nothing: control characters, and bytes that are not UTF-8, stand as a
//! backslash, an x and two hexadecimal digits.
std::string printable(const std::string& text);

//! As above, of several lines, with tabs.
std::string printable_lines(const std::string& text);

}  // namespace ideotype
