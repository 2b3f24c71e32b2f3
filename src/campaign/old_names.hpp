// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "ideotype/campaign/migration.hpp"

namespace ideotype {

//! Whether it stands further up.
bool is_before(const OldName& a, const OldName& b);

//! Gives the entries of a file with old names those of today, at the places
//! where they stand, and returns the old names in the order of the file. A
//! table that has both keeps the new one.
std::vector<OldName> rename_entries(toml::table& top, const std::string& file);

}  // namespace ideotype
