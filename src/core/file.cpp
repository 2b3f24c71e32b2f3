// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/file.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

namespace ideotype {

namespace {

//! Reads an open file to its end; gives up beyond `limit` bytes.
FileText read_open(int file, std::uintmax_t limit) {
    FileText result;
    struct stat status {};
    if (fstat(file, &status) == 0 && !S_ISREG(status.st_mode)) {
        result.why = describe_kind(status) + ", no regular file";
        return result;
    }
    std::array<char, 1U << 16U> buffer{};
    for (;;) {
        const ssize_t count = ::read(file, buffer.data(), buffer.size());
        if (count == 0) {
            result.is_there = true;
            return result;
        }
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) {
            result.why = std::generic_category().message(errno);
            return result;
        }
        result.text.append(buffer.data(), static_cast<std::size_t>(count));
        if (result.text.size() > limit) {
            result.why =
                fmt::format("larger than the limit of {} MiB", limit >> 20U);
            return result;
        }
    }
}

}  // namespace

std::string describe_kind(const struct stat& status) {
    if (S_ISDIR(status.st_mode)) return "a folder";
    if (S_ISFIFO(status.st_mode)) return "a named pipe";
    if (S_ISSOCK(status.st_mode)) return "a socket";
    return "a device";
}

std::string FileText::refusal(const std::string& path) const {
    return why.empty() ? "cannot read " + path
                       : fmt::format("cannot read {} ({})", path, why);
}

FileText read_file(const std::string& path, std::uintmax_t limit) {
    // Without O_NONBLOCK, open() would wait for a writer of a pipe.
    const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) {
        FileText missing;
        if (errno != ENOENT)
            missing.why = std::generic_category().message(errno);
        return missing;
    }
    FileText result = read_open(file, limit);
    ::close(file);
    return result;
}

}  // namespace ideotype
