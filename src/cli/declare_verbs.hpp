// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "run/run.hpp"

namespace CLI {
class App;
}

namespace ideotype {

//! Adds all verbs to a command line. Parsing it sets the action to what the
//! given verb does, which returns an exit code.
//! @param words of the command line, the program's name first
void declare_verbs(CLI::App& app, const std::vector<std::string>& words,
                   std::function<int()>& action);

void declare_run(CLI::App& verb, RunOptions& options);

//! Declares the verb `sensitivity`, which evaluates the design of a study.
void declare_sensitivity(CLI::App& verb, RunOptions& options);

//! Collective over the ranks that a launcher has started, if any.
ExitCode start_run(const RunOptions& options);

//! Adds the verbs that the Python package answers to the help of the program.
void declare_python_verbs(CLI::App& app);

//! Tells whether the Python package answers a verb.
bool is_python_verb(const std::string& verb);

//! Becomes the Python that $IDEOTYPE_PYTHON names, else the first python3 of
//! the PATH, which answers a verb or says how to install the package; sets
//! IDEOTYPE_EXECUTABLE to this program if it is not set.
//! @param words verb and arguments
//! @throws Error of wrong usage if there is no such Python.
[[noreturn]] void hand_to_python(const std::vector<std::string>& words);

}  // namespace ideotype
