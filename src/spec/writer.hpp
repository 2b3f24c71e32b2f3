// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "spec/section.hpp"

namespace ideotype {

//! Formats the value of a key as canonical TOML, the shortest text that reads
//! back as the same value; "" if there is no value.
std::string toml_text(const BoundKey& key);

//! Formats a local clock time [h] as TOML: "07:00:00".
std::string clock_text(double hours);

//! Formats the range of a key, such as `-90 .. 90 deg`.
std::string range_text(const Key& key);

//! Returns the default of a key, as TOML or in words.
//! @param usual record in which all members have their defaults
std::string default_text(const Key& key, const void* usual);

//! Returns the keys of a record that differ from their defaults, one per line.
std::string changed_keys(const Description& description, const void* record);

// Texts of tables for which special code exists.
std::string baseline_text(const CropSpec& crop, const std::string& name);
std::string component_crop_text(const CropSpec& crop, const std::string& name);
//! Returns the table of a crop's own bounds, or "" if there are none.
std::string own_bounds_text(const CropSpec& crop, const std::string& name);

//! Formats a campaign as canonical TOML: every key in a fixed order, axes as
//! arrays of tables, and the plant inlined.
std::string resolved_text(const Spec& spec);

//! Returns the text of a crop file.
std::string crop_file_text(const CropSpec& crop);

//! An accuracy key, such as "light.paths", which trades speed for accuracy.
struct AccuracyKey {
    std::string path;
    double value = 0;
    //! Values that `fidelity` tries, most accurate last.
    std::vector<double> values;
};

//! Returns the accuracy keys of those tables that occur only once.
std::vector<AccuracyKey> accuracy_keys(const Spec& spec);

}  // namespace ideotype
