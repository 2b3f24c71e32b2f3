// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/commands.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! The default objective of new campaigns.
inline constexpr const char* usual_objective = "carbon_balance";

//! Returns whether a plant is a file, not a built-in crop.
bool is_file(const std::string& plant);

//! Parses a number.
//! @throws Error (usage) if the answer is not a number.
double to_number(const std::string& answer);

//! Parses a date.
//! @throws Error (usage) if the answer is not a date.
Date date_of(const std::string& answer);

//! Checks all given answers, and asks for missing ones on a terminal.
//! @throws Error (usage) with a line for each wrong or missing option.
//! @throws InputError if the only problems are in files that options name.
void complete(NewOptions& options);

}  // namespace ideotype
