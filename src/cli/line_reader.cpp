// SPDX-License-Identifier: Apache-2.0
#include "line_reader.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <poll.h>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

std::optional<Line> LineReader::next(double seconds) {
    for (;;) {
        if (auto line = take()) return line;
        if (is_closed_ || !read_more(seconds)) return std::nullopt;
    }
}

//! What has arrived in full; at the end also a line that is not ended.
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

//! False if nothing arrived.
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

}  // namespace ideotype
