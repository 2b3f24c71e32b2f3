// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "handle.hpp"

namespace ideotype {

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text);
void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value);

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

}  // namespace ideotype
