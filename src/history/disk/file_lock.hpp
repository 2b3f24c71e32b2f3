// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Returns whether an open file is the file at a path.
bool is_at(const std::string& path, int descriptor);

//! The right to write a file, held by one process at a time on all hosts that
//! share the file system. It is a lock of the system on the file, of a kind
//! that does not conflict with HDF5's locks and excludes no reader. A killed
//! process loses the lock.
class FileLock {
  public:
    //! Locks a file that exists.
    //! @throws InUseError naming the process that has the lock. Where the
    //! file system has no locks, only processes of this host are kept out.
    explicit FileLock(const std::string& file);

    //! Creates and locks `<file>.new`, which the caller fills and renames;
    //! otherwise the lock removes it. The rest of a killed process is used
    //! again. @throws InUseError if it is locked, Error (refused) if a file of
    //! this name is not plain or has a second name.
    static FileLock of_new(const std::string& file);

    //! Returns false where the file system has no locks.
    bool is_exclusive() const { return is_exclusive_; }

    //! Returns whether the locked file is at this path.
    bool is_of(const std::string& path) const;

    //! Returns a path that leads to the locked file even if it was renamed.
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
