// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! The urgency of a line of a log, the most urgent first.
enum class LogLevel { error, warning, info, debug };

//! Width of the terminal on which somebody looks at this standard stream (1 or
//! 2) of the program; 0: it is a log.
int columns_of(int file);

//! The messages of a verb about its work, on the standard error; in a log file
//! with the time before each line.
class Log {
  public:
    //! @param least the least urgent level that is told
    explicit Log(LogLevel least);

    bool tells(LogLevel level) const { return level <= least_; }

    //! Writes "ideotype: text" or "ideotype: warning: text" of some lines.
    void write(LogLevel level, const std::string& text) const;

  private:
    LogLevel least_;
    bool is_on_terminal_;
};

}  // namespace ideotype
