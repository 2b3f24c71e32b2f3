// SPDX-License-Identifier: Apache-2.0
#include "log.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <sstream>
#include <unistd.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "ideotype/core/text.hpp"
#include "progress.hpp"

namespace ideotype {

bool is_watched(int file) {
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
        return isatty(file) == 1;
    // Open MPI gives its ranks terminals and pipes of its own, so there
    // mpirun's streams are what counts.
    const int starter =
        open(fmt::format("/proc/{}/fd/{}", getppid(), file).c_str(),
             O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (starter < 0) return false;
    const bool is_terminal = isatty(starter) == 1;
    close(starter);
    return is_terminal;
}

std::string with_time(const std::string& text) {
    const std::string time = utc_now() + "  ";
    std::istringstream lines(text);
    std::string all;
    for (std::string line; std::getline(lines, line);)
        all += fmt::format("{}{}{}", all.empty() ? "" : "\n", time, line);
    return all;
}

Log::Log(LogLevel least)
    : least_(least), is_on_terminal_(is_watched(STDERR_FILENO)) {}

void Log::write(LogLevel level, const std::string& text) const {
    if (!tells(level)) return;
    const std::string all =
        (level == LogLevel::warning ? "ideotype: warning: " : "ideotype: ") +
        printable_lines(text);
    fmt::print(stderr, "{}\n", is_on_terminal_ ? all : with_time(all));
}

}  // namespace ideotype
