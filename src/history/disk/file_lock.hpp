// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Returns whether an open file is the file at a path.
bool is_at(const std::string& path, int descriptor);

//! The exclusive right to write a file, among all processes on all hosts that
//! share the file system. It is an open file description lock, which neither
//! conflicts with HDF5's locks nor excludes readers. When a process is killed,
//! its lock is released.
class FileLock {
  public:
    //! Locks an existing file. On file systems without locks, only processes of
    //! this host are excluded.
    //! @throws InUseError that names the process which holds the lock.
    explicit FileLock(const std::string& file);

    //! Creates and locks `<file>.new`. The caller fills and renames it;
    //! otherwise the lock removes it. If a killed process left such a file, it
    //! is reused.
    //! @throws InUseError if the file is locked, Error (refused) if a file of
    //! this name is not regular or has a second name.
    static FileLock create_new(const std::string& file);

    //! Returns false if the file system has no locks.
    bool is_exclusive() const { return is_exclusive_; }

    //! Returns whether this path still leads to the locked file.
    bool locks(const std::string& path) const;

    //! Returns a path to the locked file that remains valid after a renaming.
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
