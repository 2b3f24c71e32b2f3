// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Returns whether an open file is the one at this path.
bool is_at(const std::string& path, int descriptor);

//! The right to write a file, held by one process at a time on all hosts that
//! share the file system. It is the system's lock on the file itself, of the
//! kind that does not meet HDF5's own, so that it keeps no reader out. A killed
//! process loses it.
class FileLock {
  public:
    //! Locks a file that exists.
    //! @throws InUseError naming the process that has the lock. Where the
    //! file system has no locks, only processes of this host are kept out.
    explicit FileLock(const std::string& file);

    //! Creates and locks `<file>.new`, which is to be filled and renamed, and
    //! is removed with the lock if it was not. What a killed process left of it
    //! is used again.
    //! @throws InUseError as above, Error (refused) if there is something that
    //! is no plain file or has another name too.
    static FileLock of_new(const std::string& file);

    //! Returns false where the file system has no locks.
    bool is_exclusive() const { return is_exclusive_; }

    //! Returns whether the locked file is at this path.
    bool is_of(const std::string& path) const;

    //! Returns a path that leads to the locked file whatever became of its
    //! name.
    std::string open_path() const;

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&&) = delete;
    ~FileLock();

  private:
    FileLock(const std::string& file, std::string path, int flags);

    std::string path_;
    int descriptor_ = -1;
    bool is_new_ = false;
    bool is_exclusive_ = true;
};

}  // namespace ideotype
