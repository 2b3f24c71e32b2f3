// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ideotype {

//! An option or argument, as --help tells of it.
struct DescribedOption {
    std::vector<std::string> names;    //!< with their dashes
    std::string about;                 //!< one line
    std::string value;                 //!< kind of its values; flags have none
    std::vector<std::string> choices;  //!< values, if there are only these
    int values = 0;                    //!< how many it takes at most
    bool is_positional = false;
    bool is_repeated = false;
    std::vector<std::string> needs, excludes;  //!< names of others
};

//! All options of a verb, or of the program itself, but hidden ones.
std::vector<DescribedOption> describe_options(const CLI::App& verb);

//! A page for man(1).
std::string man_page(const CLI::App& app);

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

//! Adds the hidden option --describe man, bash or zsh, which prints one of
//! these. It must come after all verbs.
void declare_describe(CLI::App& app);

}  // namespace ideotype
