// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ideotype/run/run.hpp"

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

//! What rank 0 does once all cases are finished.
using AtEnd = std::function<void(const RunOptions&)>;
ExitCode start_run(const RunCommand& command, const AtEnd& at_end);

}  // namespace ideotype
