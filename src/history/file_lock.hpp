// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! The right to write a file, held by one process at a time on all hosts that
//! share the file system. It is the system's lock on `<file>.lock`, because
//! HDF5's lock on the file itself would keep readers out. A killed process
//! loses it; what remains of the file is harmless.
class FileLock {
  public:
    //! @throws InUseError naming the process that has the lock. Where the
    //! file system has no locks, only processes of this host are kept out.
    explicit FileLock(const std::string& file);

    //! False where the file system has no locks.
    bool is_exclusive() const { return is_exclusive_; }

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&&) = delete;
    ~FileLock();

  private:
    std::string path_;
    int descriptor_ = -1;
    bool is_exclusive_ = true;
};

}  // namespace ideotype
