// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <toml++/toml.h>

namespace ideotype {

//! Returns whether a key that this version does not have changes nothing: it
//! has its former default, which now always holds.
//! @param key section and name, such as "search.step"
bool has_former_default(const std::string& key, const toml::node& value);

}  // namespace ideotype
