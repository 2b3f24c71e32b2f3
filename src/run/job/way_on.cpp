// SPDX-License-Identifier: Apache-2.0
#include "way_on.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/core/mapped.hpp"
#include "ideotype/core/text.hpp"

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

//! Splits a line made by quoted() into words. The result for any other line is
//! arbitrary.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '\'')
            is_quoted = !is_quoted;
        else if (line[i] == ' ' && !is_quoted)
            words.emplace_back();
        else if (line[i] != '\\' || is_quoted || ++i < line.size())
            words.back() += line[i];
    return words;
}

bool contains(const std::string& command, const std::string& option) {
    return (command + " ").find(" " + option + " ") != std::string::npos ||
           command.find(" " + option + "=") != std::string::npos;
}

}  // namespace

std::string quoted(const std::vector<std::string>& words) {
    const auto quoted_words =
        mapped(words, [](const std::string& word) { return quoted(word); });
    return fmt::format("{}", fmt::join(quoted_words, " "));
}

bool is_start(const std::string& line) {
    const std::vector<std::string> words = words_of(line);
    return words.size() > 2 && quoted(words) == line &&
           printable(line) == line &&
           std::filesystem::path(words[0]).filename() == "ideotype" &&
           (words[1] == "run" || words[1] == "sensitivity");
}

std::string way_on(const std::string& command, int ranks,
                   const std::string& launcher) {
    const std::string start =
        launcher.empty() ? fmt::format("mpirun -n {}", ranks) : launcher;
    return (ranks > 1 ? start + ' ' : "") + command +
           (contains(command, "--resume") ? "" : " --resume");
}

}  // namespace ideotype
