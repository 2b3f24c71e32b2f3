// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spec/section.hpp"

namespace ideotype {

//! A number of a campaign that a search or a study may vary, by its name in
//! --set.
struct VariableKey {
    std::string section;  //!< section name for messages
    std::string name;     //!< name such as "optics.soil_albedo"
    BoundKey key;
    std::size_t tables;  //!< number of tables of this kind
    bool is_there;       //!< whether the campaign has the table
};

//! Returns the keys of the tables that describe plants and their surroundings.
//! @param spec campaign, whose values the keys point at
std::vector<VariableKey> variable_keys(Spec& spec);

//! Sets a number of a campaign.
//! @param key name of a key in variable_keys() with one number
void set_key(Spec& spec, const std::string& key, double value);

//! Fills in the units and values of the keys that a search or a study varies.
void complete_factors(Spec& spec);

}  // namespace ideotype
