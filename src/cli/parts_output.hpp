// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/canopy.hpp"
#include "json.hpp"

namespace ideotype {

//! Tells leaf area, absorbed PAR and net assimilation on a mean day:
//! `components` per area of all ground, where there are several, and `rows` per
//! area of the ground that is nearest to each, where they are told apart.
Json parts_json(const CanopyReport& report);

//! Prints the same as tables.
void print_parts(const CanopyReport& report);

}  // namespace ideotype
