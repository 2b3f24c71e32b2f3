// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! Tells the user, and returns the code for the shell.
ExitCode report_error(const std::exception& error);

}  // namespace ideotype
