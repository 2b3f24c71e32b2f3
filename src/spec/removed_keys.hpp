// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <toml++/toml.h>

namespace ideotype {

//! Returns whether a removed key has no effect, because its value is the former
//! default, which is now fixed.
//! @param key section and name, such as "search.step"
bool has_former_default(const std::string& key, const toml::node& value);

}  // namespace ideotype
