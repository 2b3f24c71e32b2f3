#pragma once

#include "draft.hpp"
#include "report.hpp"

namespace ideotype {

//! Checks values against each other: contradictions, duplicate names, a
//! baseline outside its bounds.
void check_draft(const Draft& draft, Report& report);

//! That part of it which concerns the plant alone.
void check_plant(const Draft& draft, Report& report);

//! That part of it which concerns sites, days and the light of their cases.
void check_sky(const Campaign& campaign, Report& report);

}  // namespace ideotype
