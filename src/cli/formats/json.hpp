// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! A JSON object that preserves the order of insertion.
using Json = nlohmann::ordered_json;

//! Returns {"mean": x, "standard_error": s}; s is null if it is unknown.
inline Json to_json(Estimate x) {
    return {{"mean", x.mean}, {"standard_error", x.standard_error}};
}

//! Formats JSON as indented text. Bytes that are not UTF-8 are replaced.
inline std::string to_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

//! Formats a number, a text or a list in one line. An estimate becomes the mean
//! ± half of its 95 % confidence interval.
std::string text_of(const Json& value);

//! Prints an object as indented text. Each number gets a line, nested objects
//! follow their names, and lists of objects become tables.
void print_outline(const Json& json, std::size_t indent = 0);

//! Prints objects as the rows of a table. The columns are those members that
//! are not objects.
void print_table(const Json& rows, std::size_t indent);

//! Formats JSON in one line, without spaces.
inline std::string to_line(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ideotype
