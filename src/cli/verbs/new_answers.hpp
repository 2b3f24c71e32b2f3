// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/verbs.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! The objective of new campaigns that name none.
inline constexpr const char* usual_objective = "carbon_balance";

//! Returns whether a plant is a file, not a crop that the program knows.
bool is_file(const std::string& plant);

//! Returns the number that an answer is.
//! @throws Error (usage) if the answer is no number.
double to_number(const std::string& answer);

//! Returns the date that an answer is.
//! @throws Error (usage) if the answer is no date.
Date date_of(const std::string& answer);

//! Checks the given answers, all of them before it throws, and asks for missing
//! ones on a terminal.
//! @throws Error (usage) with a line for each wrong or missing option.
//! @throws InputError if only the files that options name have problems.
void complete(NewOptions& options);

}  // namespace ideotype
