// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "handle.hpp"

namespace ideotype {

//! An open file as memory. What is stored there is in the system's hands at
//! once, as after a write, for a hundredth of its price: it outlives a kill of
//! this process, and other processes read it.
class Mapping {
  public:
    //! Maps a file, or returns null where the system has not reserved the room
    //! for the whole file: a full disk would end the process instead of failing
    //! a write. From then on SIGBUS, which tells of a file cut short, ends the
    //! process with a message.
    static std::unique_ptr<Mapping> of(hid_t file);

    ~Mapping();
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    //! Returns the place of the first value of a dataset, as it is in the file;
    //! null unless the dataset is one block.
    char* find(hid_t dataset) const;

    //! Returns false once somebody cut the file short: what is lost may not be
    //! touched.
    bool is_whole() const;

  private:
    Mapping(int descriptor, char* begin, std::size_t size)
        : descriptor_(descriptor), begin_(begin), size_(size) {}

    int descriptor_;  //!< file descriptor that HDF5 has open
    char* begin_;
    std::size_t size_;
};

//! An open dataset, read and written by whole rows of its first dimension. A
//! scalar has one row.
class Dataset {
  public:
    Dataset() = default;

    //! Opens a dataset. @throws Hdf5Error if there is none of this name.
    Dataset(hid_t location, const std::string& name);

    //! Returns the size of the first dimension.
    hsize_t rows() const;

    //! Returns an attribute that is a text, "" if there is none.
    std::string text(const std::string& attribute) const;

    //! Returns whether the dataset is the scale of a dimension.
    bool is_scale() const;

    //! Returns the class of the type of values.
    H5T_class_t kind() const { return H5Tget_class(memory_type_); }

    //! Returns the number of values in one row.
    std::size_t width() const { return width_; }

    //! Returns how many whole rows lie before this position in the file. No row
    //! of a compressed dataset has a position.
    hsize_t rows_before(haddr_t end) const;

    //! Reads and writes from now on in the memory that a file is mapped to.
    //! Nothing changes for values that are stored otherwise than in memory, or
    //! not in one block. The mapping must outlive this object.
    void use(const Mapping& mapping);

    //! Writes as many rows as there are values for, which have the dataset's
    //! type in memory.
    template <class Values>
    void write(hsize_t first, const Values& values) {
        put(first, std::data(values), std::size(values),
            sizeof(*std::data(values)));
    }

    //! Writes one value of a dataset with one value per row.
    template <class Value>
    void write_one(hsize_t row, const Value& value) {
        put(row, &value, 1, sizeof(Value));
    }

    //! Reads rows, one after the other.
    template <class Value>
    std::vector<Value> read(hsize_t first, hsize_t count) const {
        std::vector<Value> values(static_cast<std::size_t>(count) * width_);
        get(first, values.data(), values.size(), sizeof(Value));
        return values;
    }

    //! Reads rows as the bytes that the file has.
    std::vector<char> bytes(hsize_t first, hsize_t count) const;

    //! Writes and reads fixed-length strings; too long ones are cut.
    void write_text(hsize_t row, const std::string& text);
    std::vector<std::string> read_text(hsize_t first, hsize_t count) const;

  private:
    struct Selection {
        Handle memory;
        Handle file;
    };

    void check_value_size(std::size_t value_size) const;
    Selection select(hsize_t first, std::size_t values) const;
    void put(hsize_t first, const void* values, std::size_t count,
             std::size_t value_size);
    void get(hsize_t first, void* values, std::size_t count,
             std::size_t value_size) const;
    void fetch(hid_t type, hsize_t first, void* values,
               std::size_t count) const;

    //! Returns the place of a row in memory. @throws Hdf5Error if there are no
    //! such rows.
    char* at(hsize_t first, std::size_t values) const;

    std::string name_;
    Handle id_;
    Handle memory_type_;
    std::size_t value_size_ = 0;
    std::size_t width_ = 1;
    char* mapped_ = nullptr;  //!< place of all rows; null: HDF5 moves them
    std::size_t mapped_values_ = 0;
};

}  // namespace ideotype
