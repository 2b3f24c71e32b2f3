// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spec/section.hpp"

namespace ideotype {

//! A numeric key of a campaign that a search or a study may vary.
struct VariableKey {
    std::string section;  //!< section name for messages
    std::string name;     //!< name, as for --set: "optics.soil_albedo"
    BoundKey key;
    std::size_t tables;  //!< number of tables of this kind
    bool is_there;       //!< whether the campaign contains the table
};

//! Returns the numeric keys of tables that describe plants and their
//! environment.
//! @param spec campaign that contains the values of the keys
std::vector<VariableKey> variable_keys(Spec& spec);

//! Sets a number of a campaign.
//! @param key name of one of variable_keys() that has a single number
void set_key(Spec& spec, const std::string& key, double value);

//! Fills in the units and values of varied keys.
void complete_factors(Spec& spec);

}  // namespace ideotype
