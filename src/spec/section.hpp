// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spec/key.hpp"
#include "spec/spec.hpp"

namespace ideotype {

//! A key and the address of its value in a record.
struct BoundKey {
    const Key& key;
    Target value;
};

//! The keys of a table, with the record that stores their values.
struct Section {
    std::string name;  //!< name for messages, such as "field.variation"
    std::span<const Key> keys;
    void* record = nullptr;
    //! Distance between the records of consecutive keys [bytes]; 0: all keys
    //! belong to one record.
    std::size_t stride = 0;

    BoundKey operator[](std::size_t key) const {
        return {keys[key],
                keys[key].place(static_cast<char*>(record) + key * stride)};
    }
};

//! Returns the names that a crop defines.
KnownNames names_of(const CropSpec& crop);

//! Returns the texts that a key allows; none: any.
std::vector<std::string> allowed_texts(const Key& key,
                                       const KnownNames& known = {});

//! Returns whether a key must be given.
bool is_required(const Key& key, const KnownNames& known);

//! Returns the numbers of a key; nothing if its value is not numeric.
std::optional<std::vector<double>> numbers_of(const BoundKey& key);

//! Returns the fault of a number as the value of a key, or "" if it has none.
std::string fault_of(double value, const std::string& section, const Key& key);

//! Returns the keys of own bounds of a crop: one for each trait, with the range
//! of its measure. Key names refer to the traits, which must outlive the keys.
std::vector<Key> own_bounds_keys(const CropSpec& crop);

}  // namespace ideotype
