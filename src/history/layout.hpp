// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "handle.hpp"
#include "ideotype/core/quantity.hpp"

namespace ideotype {

//! Returns the type of UTF-8 strings of a fixed number of bytes, padded with
//! NUL.
Handle string_type(std::size_t size);

//! The following functions return the types of Status, Origin and bool. They
//! are enumerations of 8 bits; h5py reads the last as bool.
Handle status_type();
Handle origin_type();
Handle bool_type();

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text);
void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value);

//! Lists the names of an object's attributes. It omits attributes of dimension
//! scales, which contain addresses in the file.
std::vector<std::string> list_attributes(hid_t object);

//! An attribute: its type in the file and its bytes.
struct Attribute {
    Attribute(hid_t object, const std::string& name);

    Handle type;
    std::vector<char> bytes;
};

//! Returns a string attribute of an object, or "" if it does not exist.
std::string text_attribute(hid_t object, const std::string& name);

//! Returns a numeric attribute, converted to the native type Value.
template <class Value>
Value number_attribute(hid_t object, const std::string& name,
                       hid_t memory_type) {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                           "open attribute " + name);
    Value value{};
    checked(H5Aread(attribute, memory_type, &value), "read attribute " + name);
    return value;
}

//! Lists the paths of all datasets in a file or group, sorted by name.
std::vector<std::string> list_datasets(hid_t location);

//! The time at which disk space is allocated to a dataset.
enum class Room {
    at_once,    //!< at creation, by writing the empty value
    as_needed,  //!< when rows are written; until then they are holes of zeros
};

//! The declaration of a dataset, which does not change after creation.
struct DatasetForm {
    std::string name;
    hid_t type = -1;
    //! Names of axes in the group; none for a scalar.
    std::vector<std::string> axes{};
    std::string unit = "1";  //!< unit; "" for texts
    std::string meaning{};
    //! Value of unwritten numbers, in the native type; null means zero.
    const void* empty = nullptr;
    Room room = Room::at_once;
};

//! Creates a dataset as one block at a fixed position, with a dimension scale
//! on each axis. A single block needs no chunk index; HDF5 could not read a
//! damaged index after a kill that split a write at the end of a memory page.
//! @param group group that contains a scale for each axis
Handle create_dataset(hid_t group, const DatasetForm& form);

//! Creates the dimension scale of an axis.
void create_axis(hid_t group, const Axis& axis);

//! Creates and fills a dataset of strings, one for each position on its axis.
//! Their length is that of the longest; the type in `form` is ignored.
void create_texts(hid_t group, DatasetForm form,
                  const std::vector<std::string>& texts);

Handle create_group(hid_t parent, const std::string& name);

//! Returns whether a group contains an object of this name.
bool exists(hid_t group, const std::string& name);

//! Reads an axis from its dimension scale.
Axis read_axis(hid_t group, const std::string& name);

}  // namespace ideotype
