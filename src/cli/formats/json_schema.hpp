// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/formats/json.hpp"

namespace ideotype {

//! Returns the JSON Schema (draft 2020-12) of campaigns as TOML parsers read
//! them: dates and times are texts. Editors use the schema to complete and
//! check keys. It covers types, ranges and required keys of single tables;
//! `ideotype check` also checks values against each other.
Json campaign_schema();

//! Returns the schema as text.
std::string campaign_schema_text();

//! Returns whether a text is the campaign schema of any version.
bool is_campaign_schema(const std::string& text);

}  // namespace ideotype
