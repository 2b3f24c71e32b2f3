// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Returns whether an open file is the file at a path.
bool is_at(const std::string& path, int descriptor);

//! The exclusive right to write a file, among all processes on all hosts that
//! share the file system. It is an open file description lock, which does not
//! conflict with HDF5's locks and does not exclude readers. A killed process
//! loses the lock.
class FileLock {
  public:
    //! Locks an existing file.
    //! @throws InUseError that names the process with the lock. On file systems
    //! without locks, only processes of this host are excluded.
    explicit FileLock(const std::string& file);

    //! Creates and locks `<file>.new`, which the caller fills and renames;
    //! otherwise the lock removes it. A file left by a killed process is
    //! reused. @throws InUseError if it is locked, Error (refused) if a file of
    //! this name is not regular or has a second name.
    static FileLock create_new(const std::string& file);

    //! Returns false where the file system has no locks.
    bool is_exclusive() const { return is_exclusive_; }

    //! Returns whether the locked file is at this path.
    bool locks(const std::string& path) const;

    //! Returns a path to the locked file that remains valid if it is renamed.
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
