// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! Keys stay in the order in which they are written.
using Json = nlohmann::ordered_json;

//! Returns {"mean": x, "standard_error": s}; an unknown s is null.
inline Json to_json(Estimate x) {
    return {{"mean", x.mean}, {"standard_error", x.standard_error}};
}

//! Indented text; bytes of names that are no UTF-8 are replaced.
inline std::string to_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

//! Returns a number, a text or a list for people in one line; an estimate with
//! half of its 95 % confidence interval.
std::string text_of(const Json& value);

//! Prints an object for people: a line for each number, below the name of an
//! object what is in it, and a list of objects as a table.
void print_outline(const Json& json, std::size_t indent = 0);

//! Prints objects as a table, whose columns are members that are no objects.
void print_table(const Json& rows, std::size_t indent);

//! Text without spaces and ends of lines.
inline std::string to_line(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ideotype
