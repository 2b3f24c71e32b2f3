// SPDX-License-Identifier: Apache-2.0
#include "log.hpp"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sstream>
#include <unistd.h>

#include <fmt/format.h>
#include <sys/ioctl.h>

#include "ideotype/core/text.hpp"
#include "progress.hpp"

namespace ideotype {

int columns_of(int file) {
    const auto width_of = [](int terminal) {
        if (isatty(terminal) != 1) return 0;
        struct winsize size {};
        const bool is_known =
            ioctl(terminal, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
        return is_known ? static_cast<int>(size.ws_col) : 80;
    };
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) return width_of(file);
    // Open MPI gives other terminals and pipes to its ranks, so examine the
    // streams of mpirun.
    const int starter =
        open(fmt::format("/proc/{}/fd/{}", getppid(), file).c_str(),
             O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (starter < 0) return 0;
    const int width = width_of(starter);
    close(starter);
    return width;
}

namespace {

//! Prefixes each line of a text with the time (UTC, ISO 8601).
std::string with_time(const std::string& text) {
    const std::string time = utc_now() + "  ";
    std::istringstream lines(text);
    std::string stamped;
    for (std::string line; std::getline(lines, line);)
        stamped +=
            fmt::format("{}{}{}", stamped.empty() ? "" : "\n", time, line);
    return stamped;
}

}  // namespace

Log::Log(LogLevel least)
    : least_(least), is_on_terminal_(columns_of(STDERR_FILENO) > 0) {}

void Log::write(LogLevel level, const std::string& text) const {
    if (!tells(level)) return;
    const std::string message =
        (level == LogLevel::warning ? "ideotype: warning: " : "ideotype: ") +
        printable_lines(text);
    fmt::print(stderr, "{}\n", is_on_terminal_ ? message : with_time(message));
}

}  // namespace ideotype
