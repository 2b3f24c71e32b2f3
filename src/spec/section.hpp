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

//! A key, with the address of its value in a record.
struct BoundKey {
    const Key& key;
    Target value;
};

//! The keys of a table, with the record that stores their values.
struct Section {
    std::string name;  //!< name for messages, such as "field.variation"
    std::span<const Key> keys;
    void* record = nullptr;
    //! Distance between the values of consecutive keys [bytes] if each key
    //! belongs to another record; 0 if all keys belong to one record.
    std::size_t stride = 0;

    BoundKey operator[](std::size_t key) const {
        return {keys[key],
                keys[key].place(static_cast<char*>(record) + key * stride)};
    }
};

//! Returns the names that a crop defines.
KnownNames names_of(const CropSpec& crop);

//! Returns the texts that a key allows; none if it allows any text.
std::vector<std::string> allowed_texts(const Key& key,
                                       const KnownNames& known = {});

//! Returns whether a key must be given.
bool is_required(const Key& key, const KnownNames& known);

//! Returns the value of a key as numbers, or nothing if it is not numeric. A
//! key without a value has none.
std::optional<std::vector<double>> numbers_of(const BoundKey& key);

//! Returns whether the values of a key are whole numbers.
bool is_integer(const BoundKey& key);

//! Describes the fault of a number as the value of a key; "" if it is valid.
std::string fault_of(double value, const std::string& section, const Key& key);

//! Returns the keys of a crop's own bounds, one for each trait, with the range
//! of its measure. The keys refer to the traits, which must outlive them.
std::vector<Key> own_bounds_keys(const CropSpec& crop);

}  // namespace ideotype
