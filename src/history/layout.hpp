// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "handle.hpp"
#include "ideotype/core/quantity.hpp"

namespace ideotype {

//! Returns the type of UTF-8 texts of this many bytes, padded with NUL.
Handle string_type(std::size_t size);

//! The following functions return the types of Status, Origin and yes/no, which
//! are enumerations of 8 bits. h5py reads yes/no as bool.
Handle status_type();
Handle origin_type();
Handle bool_type();

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text);
void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value);

//! Returns the names of the attributes of an object except those of HDF5's
//! dimension scales, which hold addresses in the file.
std::vector<std::string> attributes_of(hid_t object);

//! An attribute: its type in the file and its bytes.
struct Attribute {
    Attribute(hid_t object, const std::string& name);

    Handle type;
    std::vector<char> bytes;
};

//! Returns a string attribute of an object, or "" if it does not exist.
std::string text_attribute(hid_t object, const std::string& name);

//! Returns an attribute that is a number, in the native type of Value.
template <class Value>
Value number_attribute(hid_t object, const std::string& name,
                       hid_t memory_type) {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                           "open attribute " + name);
    Value value{};
    checked(H5Aread(attribute, memory_type, &value), "read attribute " + name);
    return value;
}

//! Returns the paths of all datasets of a file or group, by name.
std::vector<std::string> datasets_of(hid_t location);

//! The time at which the values of a dataset take room on the disk.
enum class Room {
    at_once,    //!< room is taken by writing the empty value
    as_needed,  //!< rows are holes of zeros until they are written
};

//! The permanent form of a dataset.
struct DatasetForm {
    std::string name;
    hid_t type = -1;
    std::vector<std::string> axes{};  //!< names in the group; none: a scalar
    std::string unit = "1";           //!< unit; "" for texts
    std::string meaning{};
    //! The value of unwritten numbers in the type's native form; null: zeros.
    const void* empty = nullptr;
    Room room = Room::at_once;
};

//! Creates a dataset as one block at a fixed place, with a dimension scale on
//! each axis. One block needs no index of chunks, which HDF5 could not read
//! after a kill that cuts a write in two at the end of a memory page.
//! @param group group that has a scale for each axis
Handle create_dataset(hid_t group, const DatasetForm& form);

//! Creates the dimension scale of an axis.
void create_axis(hid_t group, const Axis& axis);

//! Creates and fills a dataset of strings, one for each entry of its axis, as
//! long as the longest. The type in the form is ignored.
void create_texts(hid_t group, DatasetForm form,
                  const std::vector<std::string>& texts);

Handle create_group(hid_t parent, const std::string& name);

//! Returns whether a group has an object of this name.
bool exists(hid_t group, const std::string& name);

//! Returns the axis that a dimension scale describes.
Axis read_axis(hid_t group, const std::string& name);

}  // namespace ideotype
