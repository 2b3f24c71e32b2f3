// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "run/run.hpp"

namespace CLI {
class App;
}

namespace ideotype {

//! The verb `run` as typed.
struct RunCommand {
    std::vector<std::string> words;  //!< of the command line
    RunOptions options;
};

void declare_run(CLI::App& verb, RunCommand& command);

//! Collective over the ranks that a launcher has started, if any.
ExitCode start_run(const RunCommand& command);

//! The verb `sensitivity`, which evaluates the design of a study.
void declare_sensitivity(CLI::App& verb, RunCommand& command);

}  // namespace ideotype
