// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "spec/section.hpp"

namespace ideotype {

//! Returns the value of a key as canonical TOML: the shortest text from which
//! the same value is read. "" if there is no value.
std::string toml_text(const BoundKey& key);

//! Returns a local clock time [h] as TOML: "07:00:00".
std::string clock_text(double hours);

//! Returns a range such as `-90 .. 90 deg`.
std::string range_text(const Key& key);

//! Returns the default of a key, as TOML or in words.
//! @param usual record with all defaults
std::string default_text(const Key& key, const void* usual);

//! Returns the keys of a record with values other than their defaults, one per
//! line.
std::string changed_keys(const Description& description, const void* record);

// Texts of tables that are written by special code.
std::string baseline_text(const CropSpec& crop, const std::string& name);
std::string component_crop_text(const CropSpec& crop, const std::string& name);
//! Returns the table of own bounds of a crop, if there are any.
std::string own_bounds_text(const CropSpec& crop, const std::string& name);

//! Returns a campaign as canonical TOML: every key in a fixed order, axes as
//! arrays of tables, and the plant inlined.
std::string resolved_text(const Spec& spec);

//! Returns the text of a crop file.
std::string crop_file_text(const CropSpec& crop);

//! An accuracy key, which trades speed for accuracy, such as "light.paths".
struct AccuracyKey {
    std::string path;
    double value = 0;
    std::vector<double> values;  //!< values for `fidelity`, most accurate last
};

//! Returns the accuracy keys, in tables that occur once.
std::vector<AccuracyKey> accuracy_keys(const Spec& spec);

}  // namespace ideotype
