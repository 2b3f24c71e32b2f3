#include "file_lock.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include "ideotype/core/error.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

namespace {

std::string holder(int descriptor) {
    std::array<char, 128> text{};
    const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size))
                    : "another process";
}

// Only tells the user who is in the way; losing it loses nothing.
void sign(int descriptor) {
    std::array<char, 64> host{};
    gethostname(host.data(), host.size() - 1);
    const std::string text =
        fmt::format("process {} on {}", getpid(), host.data());
    if (ftruncate(descriptor, 0) == 0)
        static_cast<void>(!pwrite(descriptor, text.data(), text.size(), 0));
}

// A former holder may have removed the file between our open and our lock.
bool is_still_at(const std::string& path, int descriptor) {
    struct stat opened {};
    struct stat named {};
    return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

Writer writer_of(const std::string& path) {
    const int descriptor = open((path + ".lock").c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return Writer::closed;
    // A shared lock, held for an instant: others may look at the same time,
    // and a writer that wants to start tries again.
    const bool is_free = flock(descriptor, LOCK_SH | LOCK_NB) == 0;
    close(descriptor);
    return is_free ? Writer::killed : Writer::alive;
}

FileLock::FileLock(const std::string& file) : path_(file + ".lock") {
    constexpr int tries = 20;
    for (int failed = 0;;) {
        descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor_ < 0)
            throw Error(fmt::format("{}: cannot create: {}", path_,
                                    std::generic_category().message(errno)));
        if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 &&
            errno == EWOULDBLOCK) {
            if (++failed < tries) {
                close(descriptor_);
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
                continue;
            }
            const std::string who = holder(descriptor_);
            close(descriptor_);
            throw Error(fmt::format("{}: in use by {}; only one program can "
                                    "write a history at a time",
                                    file, who),
                        ExitCode::refused);
        }
        if (is_still_at(path_, descriptor_)) break;
        close(descriptor_);
    }
    sign(descriptor_);
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock::~FileLock() {
    if (descriptor_ < 0) return;
    // Removed before it is unlocked, so that nobody locks a file that is
    // about to vanish.
    unlink(path_.c_str());
    close(descriptor_);
}

}  // namespace ideotype
