// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <toml++/toml.h>

#include "campaign/problems.hpp"
#include "campaign/schema/schema.hpp"

namespace ideotype {

//! Reads one value to the place to which its key is bound, and checks the
//! value's type and range. section names the key in messages. The problems must
//! know the place of the value.
void read_value(const toml::node& node, const std::string& section,
                const Key& key, const Problems& problems);

}  // namespace ideotype
