#pragma once

#include <exception>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! Tells the user, and returns the code for the shell.
int report_error(const std::exception& error, ExitCode code);

}  // namespace ideotype
