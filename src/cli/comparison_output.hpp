// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "comparison.hpp"
#include "json.hpp"

namespace ideotype {

//! Matrices with a row per plant and a column per case: of the first objective
//! `mean`, `standard_error`, `difference` and `by_randomisation`, the same of
//! all single numbers in `quantities`, and lists of them in `profiles`; null
//! where a plant has no such leaf.
Json to_json(const Comparison& comparison);

//! A line per plant, case and figure.
//! @throws Error if the file cannot be written.
void write_csv(const std::string& path, const Comparison& comparison);

//! Tables: the first objective in all cases, then all that is measured.
void print(const Comparison& comparison);

}  // namespace ideotype
