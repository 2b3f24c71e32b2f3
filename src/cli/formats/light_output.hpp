// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/canopy.hpp"
#include "json.hpp"
#include "stand/light_results.hpp"

namespace ideotype {

//! Returns `incident` light and, as fractions of it, absorbed and scattered
//! light in total, by group, by layer and by hour. Also returns scalar
//! `quantities`, and the `assimilation` of leaves per ground area: a rate for a
//! single source, else the amount of a mean day. Net assimilation and net
//! carbon balance have equal standard errors.
Json to_json(const CanopyReport& report, Span span);

//! Returns the fate of the light in each waveband as fractions: absorbed by
//! each component, group and the soil, and returned to the sky. Also returns
//! `assimilation` of the components for which it is computed.
Json scene_json(const CanopyReport& report, Span span);

//! Returns leaf area, absorbed PAR and net assimilation on a mean day. If there
//! are several `components`, their values are per total ground area. If rows
//! are reported, the values of `rows` are per ground area that is nearest to
//! the row.
Json parts_json(const CanopyReport& report);

}  // namespace ideotype
