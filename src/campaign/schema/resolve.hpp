// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/draft.hpp"

namespace ideotype {

//! Returns the whole campaign as canonical TOML: every key in a fixed order,
//! axes as arrays of tables, the plant inlined.
std::string resolved_text(Draft& draft);

//! Returns the keys that are declared as a matter of accuracy, but for those of
//! tables that there are several of.
std::vector<AccuracyKey> accuracy_keys(Draft& draft);

//! Returns a crop file: the plant of a draft alone.
std::string resolved_plant_text(Draft& draft);

}  // namespace ideotype
