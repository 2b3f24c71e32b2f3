// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "spec/tables.hpp"

namespace ideotype {

//! Formats the keys of a table as a Markdown table with the type, unit, range,
//! default and meaning of each.
std::string markdown_of(const Documented& table);

//! Inserts a Markdown table between each pair of marks `<!-- keys: SECTION -->`
//! and `<!-- end of keys -->` of a text.
//! @throws Error if marks name no table, or if a table of campaigns or crop
//! files has no marks in the text.
std::string with_key_tables(const std::string& text);

}  // namespace ideotype
