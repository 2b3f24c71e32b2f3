// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <toml++/toml.h>

#include "report.hpp"
#include "schema.hpp"

namespace ideotype {

//! Reads one value to the place its key is bound to, checked for its type and
//! range. section names the key in messages. The report must know the place
//! of the value.
void read_value(const toml::node& node, const std::string& section,
                const Key& key, Report& report);

}  // namespace ideotype
