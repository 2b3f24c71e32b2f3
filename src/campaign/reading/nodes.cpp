// SPDX-License-Identifier: Apache-2.0
#include "nodes.hpp"

#include <algorithm>

namespace ideotype {

namespace {

constexpr std::size_t longest_name = 64;

// Names use ASCII only, so that they work as file names on any system.
bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           (c >= '0' && c <= '9');
}

bool is_allowed(char c) {
    return is_letter_or_digit(c) || c == '_' || c == '-';
}

}  // namespace

Location location(const toml::source_region& source, const std::string& file) {
    if (source.path && source.path->starts_with(command_line_mark))
        return {*source.path};
    // The table of a whole file has no line, so line 1 stands for it.
    return {file, std::max(1, static_cast<int>(source.begin.line)),
            std::max(1, static_cast<int>(source.begin.column))};
}

std::string kind(const toml::node& node) {
    // Names of the kinds of nodes, in the order of toml::node_type.
    constexpr const char* kinds[] = {
        "nothing",    "a table",           "a list",        "a text",
        "an integer", "a decimal number",  "true or false", "a date",
        "a time",     "a date with a time"};
    return kinds[static_cast<std::size_t>(node.type())];
}

bool is_name(const std::string& text) {
    // A leading sign would look like an option on a command line.
    return !text.empty() && text.size() <= longest_name &&
           is_letter_or_digit(text[0]) && std::ranges::all_of(text, is_allowed);
}

std::string make_name(const std::string& text) {
    std::string name = text.substr(0, longest_name);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !is_allowed(c); }, '_');
    const auto first = std::ranges::find_if(name, is_letter_or_digit);
    name.erase(name.begin(), first);
    return name.empty() ? "name" : name;
}

}  // namespace ideotype
