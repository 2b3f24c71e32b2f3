// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "spec/tables.hpp"

namespace ideotype {

//! Returns the keys of a table as a Markdown table: type, unit, range, default
//! and meaning of each.
std::string markdown_of(const Documented& table);

//! Returns a text with a Markdown table between each pair of marks `<!-- keys:
//! SECTION -->` and `<!-- end of keys -->`.
//! @throws Error if a table of campaigns or crop files has no marks, or marks
//! name no table.
std::string with_key_tables(const std::string& text);

}  // namespace ideotype
