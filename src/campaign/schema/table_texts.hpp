// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/campaign.hpp"

namespace ideotype {

//! Returns the keys of [[climate]] with other values than their defaults, one a
//! line.
std::string climate_keys(const Named<Climate>& climate);

//! Returns the keys of [field.variation] with other values than their defaults,
//! one a line.
std::string variation_keys(const PlantVariation& variation);

//! Returns the fault of a number as the value of a key, or "" if it has none.
//! @param table name of a list of tables, such as "site"
std::string fault_of(double value, const std::string& table,
                     const std::string& key);

}  // namespace ideotype
