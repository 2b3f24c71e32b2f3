// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "handle.hpp"

namespace ideotype {

//! Text of exactly this many bytes, UTF-8, padded with NUL.
Handle string_type(std::size_t size);

//! Status, Origin and yes/no as enumerations of 8 bits. The latter is the one
//! that h5py takes for bool.
Handle status_type();
Handle origin_type();
Handle bool_type();

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text);
void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value);

//! Names of the attributes of an object but those that make up HDF5's
//! dimension scales: these hold addresses in their file.
std::vector<std::string> attributes_of(hid_t object);

//! An attribute: its type in the file and its bytes.
struct Attribute {
    Attribute(hid_t object, const std::string& name);

    Handle type;
    std::vector<char> bytes;
};

//! A string attribute of an object, empty if it has none of this name.
std::string text_attribute(hid_t object, const std::string& name);

//! A number, in the native type of this kind.
template <class Value>
Value number_attribute(hid_t object, const std::string& name,
                       hid_t memory_type) {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                           "open attribute " + name);
    Value value{};
    checked(H5Aread(attribute, memory_type, &value), "read attribute " + name);
    return value;
}

//! The paths of all datasets of a file or group, by name.
std::vector<std::string> datasets_of(hid_t location);

}  // namespace ideotype
