// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "handle.hpp"

namespace ideotype {

//! An open file as memory. What is stored there is in the system's hands at
//! once, as after a write, for a hundredth of its price: it outlives a kill of
//! this process, and other processes read it.
class Mapping {
  public:
    //! None where the system has not reserved the room for the whole file: a
    //! full disk would end the process instead of failing a write. From then on
    //! SIGBUS, which tells of a file cut short, ends it with a message.
    static std::unique_ptr<Mapping> of(hid_t file);

    ~Mapping();
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    //! Where the first value of a dataset is, as it is in the file; null unless
    //! it is one block.
    char* find(hid_t dataset) const;

    //! False once somebody cut the file short: what is lost may not be touched.
    bool is_whole() const;

  private:
    Mapping(int descriptor, char* begin, std::size_t size)
        : descriptor_(descriptor), begin_(begin), size_(size) {}

    int descriptor_;  //!< of HDF5
    char* begin_;
    std::size_t size_;
};

}  // namespace ideotype
