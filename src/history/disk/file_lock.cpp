// SPDX-License-Identifier: Apache-2.0
#include "file_lock.hpp"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>

#include "history/history.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/file.hpp"
#include "ideotype/core/host.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! Returns a lock of a whole file. It is an open file description lock: it
//! belongs to the open file, not to the process, because HDF5 opens and closes
//! the same file.
struct flock make_lock() {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    return lock;
}

std::string make_path(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

//! Finds another process on this host that has opened the file for writing;
//! returns 0 if none is visible.
long find_local_writer(int descriptor) {
    constexpr fs::perms write = fs::perms::owner_write;
    std::error_code unknown;
    const fs::path file = fs::read_symlink(make_path(descriptor), unknown);
    for (fs::directory_iterator process("/proc", unknown), end; process != end;
         process.increment(unknown)) {
        const long id = std::atol(process->path().filename().c_str());
        if (id == 0 || id == getpid()) continue;
        for (fs::directory_iterator open(process->path() / "fd", unknown);
             open != end; open.increment(unknown))
            if (fs::read_symlink(open->path(), unknown) == file &&
                (open->symlink_status(unknown).permissions() & write) == write)
                return id;
    }
    return 0;
}

//! Describes the process that writes a history, as far as it is known.
std::string describe_writer(const std::string& file, int descriptor) {
    if (const long id = find_local_writer(descriptor))
        return fmt::format("process {} on {}", id, host_name());
    try {
        if (const auto last = History::read(file).last_session())
            return fmt::format("the run that {} began at {}", last->host,
                               last->started);
    } catch (const Error&) {
        // If there is no history, opening it fails.
    }
    return "another process";
}

enum class Attempt { locked, taken, unsupported };

Attempt try_lock(int descriptor) {
    struct flock lock = make_lock();
    if (fcntl(descriptor, F_OFD_SETLK, &lock) == 0) return Attempt::locked;
    return errno == EAGAIN || errno == EACCES ? Attempt::taken
                                              : Attempt::unsupported;
}

[[noreturn]] void fail_to_open(const std::string& path, bool is_new) {
    const int reason = errno;
    if (is_new && reason != ELOOP)
        throw Error(
            fmt::format("{}: no file can be created in this folder: {}; make "
                        "it writable or choose another with --out",
                        fs::absolute(path).parent_path().string(),
                        std::generic_category().message(reason)));
    throw Error(
        fmt::format("{}: this file cannot be opened to write: {}; make it a "
                    "writable file or choose another folder with --out",
                    path, std::generic_category().message(reason)),
        is_new ? ExitCode::refused : ExitCode::runtime);
}

//! Returns whether a file is regular and has only one name. Writing to it then
//! cannot overwrite another file.
bool is_plain(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
           status.st_nlink <= 1;
}

}  // namespace

bool history_exists(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) {
        const int reason = errno;
        if (reason == ENOENT || reason == ENOTDIR) return false;
        throw Error(fmt::format(
            "{}: this file cannot be opened ({}); {}", path,
            std::generic_category().message(reason),
            reason == ELOOP ? "its symbolic links form a loop: remove them"
                            : "choose a path that can be read"));
    }
    if (S_ISREG(status.st_mode)) return true;
    throw Error(
        fmt::format("{}: this is not a history of ideotype ({}); name a file",
                    path, describe_kind(status)),
        ExitCode::refused);
}

bool is_at(const std::string& path, int descriptor) {
    struct stat opened {};
    struct stat named {};
    return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

Writer find_writer(const std::string& path) {
    const int descriptor =
        open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return Writer::closed;
    struct flock lock = make_lock();
    const bool is_alive = fcntl(descriptor, F_OFD_GETLK, &lock) == 0
                              ? lock.l_type != F_UNLCK
                              : find_local_writer(descriptor) != 0;
    // The HDF5 superblock (version 3) records that the file has been opened for
    // writing.
    constexpr off_t flags_at = 11;
    unsigned char flags = 0;
    const bool is_open =
        pread(descriptor, &flags, 1, flags_at) == 1 && (flags & 1U) != 0;
    close(descriptor);
    if (is_alive) return Writer::alive;
    return is_open ? Writer::killed : Writer::closed;
}

FileLock::FileLock(const std::string& file) : FileLock(file, file, 0) {}

FileLock FileLock::create_new(const std::string& file) {
    return {file, file + ".new", O_CREAT | O_NOFOLLOW};
}

FileLock::FileLock(const std::string& file, std::string path, int flags)
    : path_(std::move(path)), is_new_((flags & O_CREAT) != 0) {
    constexpr int tries = 20;
    for (int failed = 0;;) {
        descriptor_ =
            open(path_.c_str(), flags | O_RDWR | O_NONBLOCK | O_CLOEXEC, 0666);
        if (descriptor_ < 0) fail_to_open(path_, is_new_);
        if (is_new_ && !is_plain(descriptor_)) {
            close(descriptor_);
            throw Error(
                path_ +
                    ": this is not a regular file with one name; remove it "
                    "or choose another folder with --out",
                ExitCode::refused);
        }
        const Attempt attempt = try_lock(descriptor_);
        is_exclusive_ = attempt == Attempt::locked;
        if (attempt == Attempt::taken || (attempt == Attempt::unsupported &&
                                          find_local_writer(descriptor_) > 0)) {
            // A killed process may take a moment to end.
            if (++failed < tries) {
                close(descriptor_);
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
                continue;
            }
            const std::string writer = describe_writer(file, descriptor_);
            close(descriptor_);
            throw InUseError(
                fmt::format("{}: this history is in use by {}; only one "
                            "program can write a history at a time",
                            file, writer));
        }
        // The file may have been renamed or replaced between opening and
        // locking.
        if (locks(path_)) break;
        close(descriptor_);
    }
}

bool FileLock::locks(const std::string& path) const {
    IDEOTYPE_EXPECT(descriptor_ >= 0);
    return is_at(path, descriptor_);
}

std::string FileLock::open_path() const {
    IDEOTYPE_EXPECT(descriptor_ >= 0);
    return make_path(descriptor_);
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      is_new_(other.is_new_),
      is_exclusive_(other.is_exclusive_) {}

FileLock::~FileLock() {
    if (descriptor_ < 0) return;
    if (is_new_ && locks(path_)) unlink(path_.c_str());
    close(descriptor_);
}

}  // namespace ideotype
