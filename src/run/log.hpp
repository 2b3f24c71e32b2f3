// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! The urgency of a log line, the most urgent first.
enum class LogLevel { error, warning, info, debug };

//! Returns the width of the terminal to which a standard stream (1 or 2) of the
//! program is connected, or 0 if it is a file or pipe.
int columns_of(int file);

//! Writes messages of a command to the standard error. Unless this is a
//! terminal, each line begins with a time stamp.
class Log {
  public:
    //! @param least least urgent level that is written
    explicit Log(LogLevel least);

    bool tells(LogLevel level) const { return level <= least_; }

    //! Writes "ideotype: text" or "ideotype: warning: text". The text may
    //! consist of several lines.
    void write(LogLevel level, const std::string& text) const;

  private:
    LogLevel least_;
    bool is_on_terminal_;
};

}  // namespace ideotype
