// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! The level of a log line, the most urgent first.
enum class LogLevel { error, warning, info, debug };

//! Returns the width of the terminal that shows a standard stream (1 or 2) of
//! the program, or 0 if the stream goes to a file or pipe.
int columns_of(int file);

//! Writes messages of a command to the standard error, with a time stamp on
//! each line unless it is a terminal.
class Log {
  public:
    //! @param least the least urgent level to write
    explicit Log(LogLevel least);

    bool tells(LogLevel level) const { return level <= least_; }

    //! Writes "ideotype: text" or "ideotype: warning: text"; the text may have
    //! several lines.
    void write(LogLevel level, const std::string& text) const;

  private:
    LogLevel least_;
    bool is_on_terminal_;
};

}  // namespace ideotype
