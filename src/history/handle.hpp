// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <hdf5.h>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! A failure of HDF5. History converts it to an Error that names the file.
class Hdf5Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

//! Disables HDF5's messages, and its clean-up at exit, which crashes after the
//! disk was full. Call it before a file is opened or created; the call is
//! cheap.
void initialize_hdf5();

//! Reports the failure of an action.
//! @throws Hdf5Error "cannot <action>: <HDF5's innermost reason>"
[[noreturn]] void throw_hdf5_error(const std::string& action);

//! Returns the result of an HDF5 function.
//! @throws Hdf5Error if it is negative.
template <class Result>
Result checked(Result result, const std::string& action) {
    if (result < 0) throw_hdf5_error(action);
    return result;
}

//! Owns an HDF5 identifier.
class Handle {
  public:
    using Close = herr_t (*)(hid_t);

    Handle() = default;

    //! Takes ownership of an identifier. @throws Hdf5Error if it is negative.
    Handle(hid_t id, Close closer, const std::string& action)
        : id_(checked(id, action)), close_(closer) {}

    Handle(Handle&& other) noexcept
        : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }

    // Failures are ignored: all data were flushed before, and a destructor
    // cannot report.
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }

    //! Closes the identifier and reports a failure.
    void close(const std::string& action) {
        IDEOTYPE_EXPECT(id_ >= 0);
        checked(close_(std::exchange(id_, -1)), action);
    }

    operator hid_t() const { return id_; }

  private:
    hid_t id_ = -1;
    Close close_ = nullptr;
};

}  // namespace ideotype
