// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/canopy.hpp"
#include "json.hpp"
#include "stand/light_results.hpp"

namespace ideotype {

//! Returns `incident` light and, as fractions of it, absorbed and scattered
//! light: in total, by group, by layer and by hour; scalar `quantities`; and
//! `assimilation` of leaves per ground area, as a rate for a single source,
//! else for a mean day. Net assimilation and net carbon balance have one
//! standard error.
Json to_json(const CanopyReport& report, Span span);

//! Returns the fate of the light of each waveband as fractions: by component,
//! by group, absorbed by the soil and returned to the sky; and `assimilation`
//! of components with leaves that assimilate.
Json scene_json(const CanopyReport& report, Span span);

//! Returns leaf area, absorbed PAR and net assimilation on a mean day:
//! `components` per total ground area, if there are several, and `rows` per
//! ground area nearest to each row, if rows are reported.
Json parts_json(const CanopyReport& report);

}  // namespace ideotype
