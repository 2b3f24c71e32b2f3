// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>

#include "ideotype/core/error.hpp"
#include "ideotype/run/log.hpp"

namespace ideotype {

//! Tells the user, and returns the code for the shell.
ExitCode report_error(const std::exception& error);

//! The same, in a log.
ExitCode report_error(const std::exception& error, const Log& log);

}  // namespace ideotype
