// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace ideotype {

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
