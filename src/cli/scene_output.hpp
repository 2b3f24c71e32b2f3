// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "light_output.hpp"

namespace ideotype {

//! Tells what became of the light of each waveband, in fractions: by component,
//! by group, on the soil and back to the sky; and `assimilation` of components
//! whose leaves assimilate.
Json scene_json(const CanopyReport& report, Span span);

//! Prints the same as tables, but for groups.
void print_scene(const CanopyReport& report, Span span);

}  // namespace ideotype
