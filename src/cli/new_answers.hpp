// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/cli/verbs.hpp"
#include "ideotype/climate/site.hpp"

namespace ideotype {

//! A number in the range of a key of campaigns.
//! @throws Error of wrong usage if it is something else.
double to_number(const std::string& text, const std::string& section,
                 const std::string& key);

//! @throws Error of wrong usage if it is no date.
Date to_date(const std::string& text);

//! Whether a plant is a file, not a crop that the program knows by name.
bool is_file(const std::string& plant);

//! Checks what is given, and asks for the rest on a terminal.
//! @throws Error of wrong usage, also if something is missing elsewhere.
void complete(NewOptions& options);

}  // namespace ideotype
