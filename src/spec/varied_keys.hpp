// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "spec/problems.hpp"
#include "spec/section.hpp"

namespace ideotype {

//! A key of a campaign that a search or a study may vary.
struct VariableKey {
    std::string section;         //!< section name for messages
    std::string name;            //!< name, as for --set: "optics.soil_albedo"
    BoundKey key;                //!< key in the first table of this kind
    std::vector<Target> others;  //!< its values in other tables of this kind
    bool is_there;               //!< whether the campaign contains the table
    //! Whether all tables of this kind are scenarios of one case. A varied key
    //! then has the same value in all of them; of a date, each keeps its year.
    bool is_shared;
    bool keeps_light;  //!< Table::keeps_light

    std::size_t tables() const { return 1 + others.size(); }
};

//! Returns the keys that describe plants and their environment, except names
//! and files.
//! @param spec campaign that contains the values of the keys
std::vector<VariableKey> variable_keys(Spec& spec);

//! Returns whether all tables of a kind have the same value, dates apart from
//! the year.
bool is_alike(const VariableKey& variable);

//! Returns the value of a varied key in a campaign, as TOML.
std::string value_in(const Spec& spec, const std::string& key);

//! Reports the faults of a value of a varied key at the name of the key.
void try_value(const Spec& spec, const std::string& key, const TomlValue& value,
               const Problems& problems);

//! Sets varied keys of a campaign. Plants keep their distance in the row,
//! unless the density varies.
//! @param numbers number of the gene of each factor, within bounds_of(factor)
//! @throws InputError if a key does not accept its number
void set_keys(Spec& spec, const std::vector<KeyFactor>& factors,
              std::span<const double> numbers);

//! Returns the text of a number of a varied key: the number, or the value with
//! this entry.
std::string text_of(const KeyFactor& factor, double number);

//! Returns the numbers at which a varied key is checked against other keys: all
//! values of a list, all whole numbers if they are few, and otherwise both ends
//! of the range and a point in between.
std::vector<double> tried_numbers(const KeyFactor& factor);

//! Completes varied keys: kinds, units, and the numbers of the campaign. Values
//! become canonical; numbers and dates are sorted.
void complete_factors(Spec& spec);

}  // namespace ideotype
