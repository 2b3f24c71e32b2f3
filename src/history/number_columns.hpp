// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "layout.hpp"
#include "search/outcome.hpp"

namespace ideotype {

//! The end of the name of a column of standard errors.
inline constexpr const char* error_suffix = "_standard_error";

//! Of the columns, the first ones, all that selection needs is made.
inline constexpr std::size_t essential_numbers = 4;

//! The columns of an outcome's numbers, in the order of numbers_of().
//! @param rows name of their first axis
std::vector<DatasetForm> number_forms(const OutcomeSchema& schema,
                                      const std::string& rows);

//! Row-major numbers of one row for each of number_forms().
using Numbers = std::vector<std::vector<double>>;

Numbers numbers_of(const OutcomeSchema& schema, const Outcome& outcome);

//! Gives the numbers of a row in the next column.
using NextColumn = std::function<std::span<const double>()>;

//! Takes the numbers of an outcome, one column after the other.
Outcome outcome_of(const OutcomeSchema& schema, const NextColumn& next);

//! Writes what is measured as an attribute of a group, and its axes.
void write_measured(hid_t group, const QuantitySet& measured);

//! Reads it again, also from a file that is cut short.
QuantitySet read_measured(hid_t group);

}  // namespace ideotype
