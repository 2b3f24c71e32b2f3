// SPDX-License-Identifier: Apache-2.0
#include "file_lock.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <sys/file.h>

#include "ideotype/core/error.hpp"
#include "ideotype/history/history.hpp"
#include "place.hpp"

namespace ideotype {

namespace {

std::string host_name() {
    std::array<char, 64> name{};
    gethostname(name.data(), name.size() - 1);
    return name.data();
}

std::string holder(int descriptor) {
    std::array<char, 128> text{};
    const ssize_t size = pread(descriptor, text.data(), text.size() - 1, 0);
    return size > 0 ? text.data() : "another process";
}

// Tells the user who is in the way, and other starts where there are no locks.
void sign(int descriptor) {
    const std::string text =
        fmt::format("process {} on {}", getpid(), host_name());
    if (ftruncate(descriptor, 0) == 0)
        static_cast<void>(!pwrite(descriptor, text.data(), text.size(), 0));
}

// Where the file system has no locks: whether the process that signed lives
// on this host and is this program. A process of another host can't be seen.
bool is_held_here(int descriptor) {
    const std::string who = holder(descriptor);
    long process = 0;
    std::array<char, 65> host{};
    if (std::sscanf(who.c_str(), "process %ld on %64s", &process,
                    host.data()) != 2)
        return false;
    std::error_code unknown;
    const auto program = [&](const std::string& id) {
        return std::filesystem::read_symlink("/proc/" + id + "/exe", unknown);
    };
    const auto other = program(std::to_string(process));
    return host_name() == host.data() && process != getpid() &&
           !other.empty() && other == program("self");
}

enum class Attempt { locked, taken, unsupported };

Attempt try_lock(int descriptor, int operation) {
    if (flock(descriptor, operation | LOCK_NB) == 0) return Attempt::locked;
    return errno == EWOULDBLOCK ? Attempt::taken : Attempt::unsupported;
}

[[noreturn]] void fail_to_create(const std::string& path) {
    throw Error(fmt::format(
        "{}: cannot create files in this folder: {}; make it writable or "
        "choose another with --out",
        std::filesystem::absolute(path).parent_path().string(),
        std::generic_category().message(errno)));
}

}  // namespace

Writer writer_of(const std::string& path) {
    const int descriptor =
        open((path + ".lock").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return Writer::closed;
    // A shared lock, held for an instant: others may look at the same time,
    // and a writer that wants to start tries again.
    const Attempt attempt = try_lock(descriptor, LOCK_SH);
    const bool is_alive =
        attempt == Attempt::taken ||
        (attempt == Attempt::unsupported && is_held_here(descriptor));
    close(descriptor);
    return is_alive ? Writer::alive : Writer::killed;
}

FileLock::FileLock(const std::string& file) : path_(file + ".lock") {
    constexpr int tries = 20;
    for (int failed = 0;;) {
        descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor_ < 0) fail_to_create(path_);
        const Attempt attempt = try_lock(descriptor_, LOCK_EX);
        is_exclusive_ = attempt == Attempt::locked;
        if (attempt == Attempt::taken ||
            (attempt == Attempt::unsupported && is_held_here(descriptor_))) {
            if (++failed < tries) {
                close(descriptor_);
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
                continue;
            }
            const std::string who = holder(descriptor_);
            close(descriptor_);
            throw InUseError(
                fmt::format("{}: in use by {}; only one program can write a "
                            "history at a time",
                            file, who));
        }
        // A former holder may have removed it between our open and our lock.
        if (is_at(path_, descriptor_)) break;
        close(descriptor_);
    }
    sign(descriptor_);
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      is_exclusive_(other.is_exclusive_) {}

FileLock::~FileLock() {
    if (descriptor_ < 0) return;
    // Removed before it is unlocked, so that nobody locks a file that is
    // about to vanish. If the folder was removed and the file written again,
    // the lock at this path is another's.
    if (is_at(path_, descriptor_)) unlink(path_.c_str());
    close(descriptor_);
}

}  // namespace ideotype
