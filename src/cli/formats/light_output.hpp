// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/canopy.hpp"
#include "json.hpp"
#include "stand/light_results.hpp"

namespace ideotype {

//! `incident` and, as fractions of it, what became of it: in all, by group,
//! by layer, by hour; `quantities` that are single numbers; and `assimilation`
//! of leaves per ground area: a rate of a single light, else that of a mean
//! day. Net assimilation and carbon balance have one standard error.
Json to_json(const CanopyReport& report, Span span);

//! Tells what became of the light of each waveband, in fractions: by component,
//! by group, on the soil and back to the sky; and `assimilation` of components
//! whose leaves assimilate.
Json scene_json(const CanopyReport& report, Span span);

//! Tells leaf area, absorbed PAR and net assimilation on a mean day:
//! `components` per area of all ground, where there are several, and `rows` per
//! area of the ground that is nearest to each, where they are told apart.
Json parts_json(const CanopyReport& report);

}  // namespace ideotype
