// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ideotype {

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
