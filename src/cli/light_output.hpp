// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/canopy.hpp"
#include "json.hpp"

namespace ideotype {

//! The kind of light that is told: a day in J m-2 with its hours, or a single
//! light, of which level ground receives 1.
enum class Span { day, single };

//! `incident` and, as fractions of it, what became of it: in all, by group,
//! by layer, by hour; `quantities` that are single numbers; and `assimilation`
//! of leaves per ground area: a rate of a single light, else that of a mean
//! day. All of it has the standard error of `gross`.
Json to_json(const CanopyReport& report, Span span);

//! Prints the same as tables.
void print_light(const CanopyReport& report, Span span);

//! Assimilation of a single light, which shines for a second, is told in umol.
double assimilation_scale(Span span);
const char* assimilation_unit(Span span);

}  // namespace ideotype
