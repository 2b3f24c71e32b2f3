// SPDX-License-Identifier: Apache-2.0
#include "lines.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>

#include "cli/ranks.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

std::optional<Line> LineReader::next(double seconds) {
    for (;;) {
        if (auto line = take()) return line;
        if (is_closed_ || !read_more(seconds)) return std::nullopt;
    }
}

//! Returns a complete line. At the end of the input, also returns a last line
//! without a line break.
std::optional<Line> LineReader::take() {
    const std::size_t end = buffer_.find('\n', searched_);
    if (end == std::string::npos && (!is_closed_ || has_ended())) {
        searched_ = buffer_.size();
        if (searched_ > longest) {
            is_cut_ = true;
            buffer_.clear();
            searched_ = 0;
        }
        return std::nullopt;
    }
    Line line{++lines_, buffer_.substr(0, end), std::exchange(is_cut_, false)};
    buffer_.erase(0, end == std::string::npos ? end : end + 1);
    searched_ = 0;
    return line;
}

//! Reads bytes that arrive within a time; returns false if there are none.
bool LineReader::read_more(double seconds) {
    pollfd watched{file_, POLLIN, 0};
    if (poll(&watched, 1, static_cast<int>(std::lround(1e3 * seconds))) <= 0)
        return false;
    std::array<char, 1 << 16> bytes{};
    const ssize_t count = read(file_, bytes.data(), bytes.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return false;
    if (count < 0)
        throw Error(fmt::format("cannot read the standard input: {}",
                                std::strerror(errno)));
    if (count == 0) is_closed_ = true;
    buffer_.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
}

namespace {

constexpr auto nobody_reads =
    "nobody reads the output any more (the pipe is closed)";

//! Opens the standard output of the mpirun that started this process, if it is
//! a pipe; else returns -1. Ranks write through mpirun, which crashes or
//! reports nothing when its output is closed. If a rank opens the pipe itself,
//! the rank gets the error.
int pipe_of_mpirun() {
    if (!launch_of_this_process().is_launched) return -1;
    const std::optional<std::string> mpirun = process_of_mpirun();
    if (!mpirun) return -1;
    struct stat about {};
    const std::string output = *mpirun + "/fd/1";
    if (stat(output.c_str(), &about) != 0 || !S_ISFIFO(about.st_mode))
        return -1;
    // Without O_NONBLOCK, opening a named pipe without a reader would block.
    const int file = open(output.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0 && errno == ENXIO) throw Error(nobody_reads);
    if (file >= 0) fcntl(file, F_SETFL, O_WRONLY);
    return file;
}

}  // namespace

LineWriter::LineWriter() : file_(pipe_of_mpirun()) {
    // With this, writing to a closed pipe returns an error instead of killing
    // the process.
    std::signal(SIGPIPE, SIG_IGN);
    if (file_ < 0) file_ = STDOUT_FILENO;
}

LineWriter::~LineWriter() {
    if (file_ != STDOUT_FILENO) close(file_);
}

void LineWriter::write(const std::string& line) const {
    const std::string bytes = line + "\n";
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count =
            ::write(file_, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno != EINTR)
            throw Error(
                errno == EPIPE
                    ? nobody_reads
                    : fmt::format("cannot write to the standard output: {}",
                                  std::strerror(errno)));
        if (count > 0) done += static_cast<std::size_t>(count);
    }
}

}  // namespace ideotype
