// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>

#include "ideotype/core/error.hpp"
#include "run/log.hpp"

namespace ideotype {

//! Tells the user, and returns the code for the shell.
ExitCode report_error(const std::exception& error);

//! The same, in a log.
ExitCode report_error(const std::exception& error, const Log& log);

//! Whether the program threw this itself, with a message for the user.
inline bool is_told(const std::exception& error) {
    return dynamic_cast<const Error*>(&error) != nullptr;
}

}  // namespace ideotype
