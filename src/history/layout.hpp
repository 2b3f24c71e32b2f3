// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "handle.hpp"
#include "ideotype/core/quantity.hpp"

namespace ideotype {

//! When the values of a dataset take room on the disk.
enum class Room {
    at_once,    //!< all are written with the value for empty
    as_needed,  //!< rows are holes of the file, zeros, until they are written
};

//! What a dataset will be, for its whole life.
struct DatasetForm {
    std::string name;
    hid_t type = -1;
    std::vector<std::string> axes{};  //!< of its group; none: a scalar
    std::string unit = "1";           //!< "" of texts
    std::string meaning{};
    //! Value of what is not written, in the type's native form; null: zeros.
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

//! Whether a group has an object of this name.
bool exists(hid_t group, const std::string& name);

//! The axis that a dimension scale describes.
Axis read_axis(hid_t group, const std::string& name);

}  // namespace ideotype
