// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/draft.hpp"

namespace ideotype {

//! Returns the whole campaign as canonical TOML: every key in a fixed order,
//! axes as arrays of tables, and the plant inlined.
std::string resolved_text(Draft& draft);

//! Returns the keys that trade speed for accuracy, in tables that occur once.
std::vector<AccuracyKey> accuracy_keys(Draft& draft);

//! Returns the text of a crop file with the plant of a draft.
std::string resolved_plant_text(Draft& draft);

}  // namespace ideotype
