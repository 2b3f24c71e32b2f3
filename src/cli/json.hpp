// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! Keys stay in the order in which they are written.
using Json = nlohmann::ordered_json;

//! {"mean": x, "standard_error": s}; null for a standard error that is
//! unknown.
Json to_json(Estimate x);

//! Indented text; bytes of names that are no UTF-8 are replaced.
std::string to_text(const Json& json);

//! The same without spaces and ends of lines.
std::string to_line(const Json& json);

}  // namespace ideotype
