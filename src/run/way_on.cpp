// SPDX-License-Identifier: Apache-2.0
#include "ideotype/run/way_on.hpp"

#include <fmt/format.h>

namespace ideotype {

namespace {

std::string quoted(const std::string& word) {
    constexpr const char* plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
        "_-+./:,=@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
        return word;
    std::string text = "'";
    for (const char c : word) {
        if (c == '\'')
            text += "'\\''";
        else
            text += c;
    }
    return text + "'";
}

bool contains(const std::string& command, const std::string& option) {
    return (command + " ").find(" " + option + " ") != std::string::npos ||
           command.find(" " + option + "=") != std::string::npos;
}

}  // namespace

std::string quoted(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words)
        line += (line.empty() ? "" : " ") + quoted(word);
    return line;
}

std::string way_on(const std::string& command, int ranks) {
    const bool needs_launcher = ranks > 1 && !contains(command, "--ranks");
    return (needs_launcher ? fmt::format("mpirun -n {} ", ranks) : "") +
           command + (contains(command, "--resume") ? "" : " --resume");
}

}  // namespace ideotype
