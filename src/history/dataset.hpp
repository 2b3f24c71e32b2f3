// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "handle.hpp"

namespace ideotype {

//! An open file that is mapped to memory. Stored values reach the operating
//! system at once, so other processes can read them and they survive a kill of
//! this process. A write would do the same, but takes a hundred times longer.
class Mapping {
  public:
    //! Maps a file. Afterwards SIGBUS, the signal for a truncated file, ends
    //! the process with a message. Returns null if space is not reserved for
    //! the whole file: on a full disk, storing a value would end the process,
    //! whereas a failed write can be reported.
    static std::unique_ptr<Mapping> create(hid_t file);

    ~Mapping();
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    //! Returns the address of the first value of a dataset, or null if the
    //! dataset is not a single block. Values are laid out as in the file.
    char* find(hid_t dataset) const;

    //! Returns false if the file has been truncated; its lost parts must not be
    //! accessed.
    bool is_whole() const;

  private:
    Mapping(int descriptor, char* begin, std::size_t size)
        : descriptor_(descriptor), begin_(begin), size_(size) {}

    int descriptor_;  //!< file descriptor of HDF5
    char* begin_;
    std::size_t size_;
};

//! An open dataset, read and written in whole rows of its first dimension. A
//! scalar counts as one row.
class Dataset {
  public:
    Dataset() = default;

    //! Opens a dataset.
    //! @throws Hdf5Error if there is no dataset of this name.
    Dataset(hid_t location, const std::string& name);

    //! Returns the size of the first dimension.
    hsize_t rows() const;

    //! Returns an attribute that is a string, or "" if it does not exist.
    std::string text(const std::string& attribute) const;

    //! Returns whether the dataset is the scale of a dimension.
    bool is_scale() const;

    //! Returns the HDF5 class of the values' type.
    H5T_class_t kind() const { return H5Tget_class(memory_type_); }

    //! Returns the number of values in one row.
    std::size_t width() const { return width_; }

    //! Returns the number of complete rows before a position in the file; 0 for
    //! a compressed dataset, in which rows have no fixed position.
    hsize_t rows_before(haddr_t end) const;

    //! Makes all later reads and writes use the mapped file. Does nothing if
    //! the values are converted on reading or are not in one block. The mapping
    //! must outlive this object.
    void use(const Mapping& mapping);

    //! Writes rows of values, in the type that the dataset uses in memory.
    template <class Values>
    void write(hsize_t first, const Values& values) {
        put(first, std::data(values), std::size(values),
            sizeof(*std::data(values)));
    }

    //! Writes one value to a dataset that has one value per row.
    template <class Value>
    void write_one(hsize_t row, const Value& value) {
        put(row, &value, 1, sizeof(Value));
    }

    //! Reads consecutive rows.
    template <class Value>
    std::vector<Value> read(hsize_t first, hsize_t count) const {
        std::vector<Value> values(static_cast<std::size_t>(count) * width_);
        get(first, values.data(), values.size(), sizeof(Value));
        return values;
    }

    //! Reads rows as they are stored, as bytes.
    std::vector<char> bytes(hsize_t first, hsize_t count) const;

    //! Write and read fixed-length strings; longer strings are truncated.
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

    //! @throws Hdf5Error if the row does not exist.
    char* locate(hsize_t first, std::size_t values) const;

    std::string name_;
    Handle id_;
    Handle memory_type_;
    std::size_t value_size_ = 0;
    std::size_t width_ = 1;
    char* mapped_ = nullptr;  //!< address of the rows; null if not mapped
    std::size_t mapped_values_ = 0;
};

}  // namespace ideotype
