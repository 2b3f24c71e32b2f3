#pragma once

#include <string>
#include <vector>

#include "handle.hpp"

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
    std::vector<hsize_t> sizes;  //!< empty: a scalar
    std::string unit;            //!< see analysis/FORMAT.md
    //! Value of what is not written, in the type's native form; null: zeros.
    const void* empty = nullptr;
    Room room = Room::at_once;
};

//! Creates a dataset with its unit as one block at a fixed place. A kill can
//! cut a single write in two, at the end of a memory page, and HDF5 cannot read
//! an index of chunks of which that happened; one block needs no index.
Handle create_dataset(hid_t parent, const DatasetForm& form);

//! Creates and fills a dataset of one string per row, as long as the longest.
Handle create_texts(hid_t parent, const std::string& name,
                    const std::vector<std::string>& texts);

//! Creates and fills a scalar string dataset.
void create_text(hid_t parent, const std::string& name,
                 const std::string& text);

Handle create_group(hid_t parent, const std::string& name);

void create_attribute(hid_t object, const std::string& name,
                      const std::string& text);
void create_attribute(hid_t object, const std::string& name, hid_t type,
                      const void* value);

//! Names a dimension.
void label_dimension(hid_t dataset, unsigned dimension,
                     const std::string& label);

//! Makes scale, a dataset of names, the scale of a dimension.
void attach_scale(hid_t dataset, unsigned dimension, hid_t scale);

}  // namespace ideotype
