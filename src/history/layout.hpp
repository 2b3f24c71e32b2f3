// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "handle.hpp"
#include "ideotype/core/quantity.hpp"

namespace ideotype {

//! Returns the type of texts of exactly this many bytes, UTF-8, padded with
//! NUL.
Handle string_type(std::size_t size);

//! Returns the types of Status, Origin and yes/no, which are enumerations of 8
//! bits. The last one is that which h5py takes for bool.
Handle status_type();
Handle origin_type();
Handle bool_type();

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text);
void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value);

//! Returns the names of the attributes of an object but those that make up
//! HDF5's dimension scales: these hold addresses in their file.
std::vector<std::string> attributes_of(hid_t object);

//! An attribute: its type in the file and its bytes.
struct Attribute {
    Attribute(hid_t object, const std::string& name);

    Handle type;
    std::vector<char> bytes;
};

//! Returns a string attribute of an object, empty if it has none of this name.
std::string text_attribute(hid_t object, const std::string& name);

//! Returns an attribute that is a number, in the native type of this kind.
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

//! Tells when the values of a dataset take room on the disk.
enum class Room {
    at_once,    //!< values are written with the one for empty
    as_needed,  //!< rows are holes of the file, zeros, until they are written
};

//! The form that a dataset has for its whole life.
struct DatasetForm {
    std::string name;
    hid_t type = -1;
    //! Names of axes of its group; none: a scalar.
    std::vector<std::string> axes{};
    std::string unit = "1";  //!< "" of texts
    std::string meaning{};
    //! The value of numbers that are not written, in the type's native form;
    //! null: zeros.
    const void* empty = nullptr;
    Room room = Room::at_once;
};

//! Creates a dataset as one block at a fixed place, with a dimension scale on
//! each axis. A kill can cut a single write in two, at the end of a memory
//! page, and HDF5 cannot read an index of chunks of which that happened; one
//! block needs no index.
//! @param group with a scale of the name of each axis
Handle create_dataset(hid_t group, const DatasetForm& form);

//! Creates the dimension scale of an axis.
void create_axis(hid_t group, const Axis& axis);

//! Creates and fills a dataset of strings, one for each entry of its axis, as
//! long as the longest. The type of the form is not looked at.
void create_texts(hid_t group, DatasetForm form,
                  const std::vector<std::string>& texts);

Handle create_group(hid_t parent, const std::string& name);

//! Returns whether a group has an object of this name.
bool exists(hid_t group, const std::string& name);

//! Returns the axis that a dimension scale describes.
Axis read_axis(hid_t group, const std::string& name);

}  // namespace ideotype
