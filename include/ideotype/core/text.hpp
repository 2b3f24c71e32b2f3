// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

//! One entry of a line of a table.
struct CsvField {
    std::string_view text;  //!< without blanks and quotes around it
    int column = 0;         //!< where it begins, from 1
};

//! Lines of a text, without the characters that end them.
std::vector<std::string_view> lines_of(std::string_view text);

//! Entries between commas; a comma within quotes ends none.
std::vector<CsvField> fields_of(std::string_view line);

//! The number that a text is, and nothing else.
std::optional<double> number_of(std::string_view text);

}  // namespace ideotype
