// SPDX-License-Identifier: Apache-2.0
#include "attributes.hpp"

#include <algorithm>

#include "types.hpp"

namespace ideotype {

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text) {
    create_attribute(object, name, string_type(text.size()), text.c_str());
}

void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create " + name);
    const Handle attribute(
        H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose, "create " + name);
    checked(H5Awrite(attribute, type, value), "write " + name);
}

std::string text_attribute(hid_t object, const std::string& name) {
    if (checked(H5Aexists(object, name.c_str()), "find attribute " + name) == 0)
        return "";
    const std::string action = "read attribute " + name;
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                           action);
    const Handle type(H5Aget_type(attribute), H5Tclose, action);
    if (H5Tget_class(type) != H5T_STRING) return "";
    std::string text(H5Tget_size(type), '\0');
    checked(H5Aread(attribute, type, text.data()), action);
    text.resize(std::min(text.find('\0'), text.size()));
    return text;
}

}  // namespace ideotype
