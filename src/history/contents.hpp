// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "handle.hpp"

namespace ideotype {

//! A group or dataset of a file.
struct Object {
    std::string path;  //!< "." is the root group
    bool is_dataset = false;
};

//! All objects by name, groups before what is in them.
std::vector<Object> objects_of(hid_t file);

Handle open_object(hid_t file, const Object& object);

//! Names of the attributes of an object but those that make up HDF5's
//! dimension scales: these hold addresses in their file.
std::vector<std::string> attributes_of(hid_t object);

//! An attribute or a block of a dataset: its type in the file and its bytes.
struct StoredValue {
    Handle type;
    std::vector<char> values;
};

StoredValue read_attribute(hid_t object, const std::string& name);

//! How a dataset divides into blocks of whole rows of its first dimension.
struct Blocks {
    explicit Blocks(hid_t dataset);

    Handle type;
    std::vector<hsize_t> sizes;  //!< empty: a scalar
    std::size_t row_bytes = 0;
    hsize_t rows = 1;
    hsize_t rows_per_block = 1;

    //! Calls with the first row and the number of rows of every block.
    void for_each(const std::function<void(hsize_t, hsize_t)>& action) const;
};

//! Reads one block, as the bytes of the file.
std::vector<char> read_block(hid_t dataset, const Blocks& blocks, hsize_t first,
                             hsize_t count);

}  // namespace ideotype
