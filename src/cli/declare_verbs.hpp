// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ideotype {

//! Adds all verbs to a command line. Parsing it sets the action to what the
//! given verb does, which returns an exit code.
//! @param words of the command line, the program's name first
void declare_verbs(CLI::App& app, const std::vector<std::string>& words,
                   std::function<int()>& action);

}  // namespace ideotype
