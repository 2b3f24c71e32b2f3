// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! The urgency of a line of a log, the most urgent first.
enum class LogLevel { error, warning, info, debug };

//! Returns the width of the terminal that shows a standard stream (1 or 2) of
//! the program, or 0 if the stream is a log.
int columns_of(int file);

//! The messages of a verb about its work, on the standard error, with the time
//! before each line in a log file.
class Log {
  public:
    //! @param least the least urgent level that is written
    explicit Log(LogLevel least);

    bool tells(LogLevel level) const { return level <= least_; }

    //! Writes "ideotype: text" or "ideotype: warning: text" for one or more
    //! lines.
    void write(LogLevel level, const std::string& text) const;

  private:
    LogLevel least_;
    bool is_on_terminal_;
};

}  // namespace ideotype
