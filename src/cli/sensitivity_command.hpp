// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "run_command.hpp"

namespace ideotype {

//! The verb `sensitivity` as typed.
struct SensitivityCommand {
    RunCommand run;
    std::vector<std::string> quantities;  //!< to print besides the objectives
    std::string json_path;                //!< "": none
};

void declare_sensitivity(CLI::App& verb, SensitivityCommand& command);

//! Runs the study, as start_run(), and prints its indices.
ExitCode start_sensitivity(const SensitivityCommand& command);

}  // namespace ideotype
