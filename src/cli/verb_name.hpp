#pragma once

#include <string>

namespace CLI {
class App;
}

namespace ideotype {

//! Looks whether the first word of a command line, if it is no option, is a
//! verb.
//! @throws Error of wrong usage that names the nearest verb.
void check_verb_name(const CLI::App& app, const std::string& word);

}  // namespace ideotype
