// SPDX-License-Identifier: Apache-2.0
#include "syntax.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "nodes.hpp"
#include "spelling.hpp"

namespace ideotype {

namespace {

//! The most parts of a key; campaigns need four. The parser recurses by the
//! parts, but limits only the depth of nested values.
constexpr int most_parts = 8;

//! Returns the end of a comment or text that begins at a position.
std::size_t end_of_opaque(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    if (quote == '#') return std::min(text.find('\n', begin), text.size());
    const std::string triple(3, quote);
    const bool is_long = text.substr(begin).starts_with(triple);
    const std::string_view end = is_long ? triple : std::string_view(&quote, 1);
    for (std::size_t at = begin + end.size(); at < text.size(); ++at) {
        if (text[at] == '\\' && quote == '"')
            ++at;
        else if (text.substr(at).starts_with(end))
            return at + end.size();
        else if (text[at] == '\n' && !is_long)
            return at;
    }
    return text.size();
}

//! Returns the position of a key that has more parts than any campaign needs.
std::optional<std::size_t> find_deep_key(std::string_view text) {
    int parts = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'' || c == '#') {
            at = end_of_opaque(text, at);
            continue;
        }
        if (c == '.' && ++parts > most_parts) return at;
        if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos)
            parts = 1;
        ++at;
    }
    return std::nullopt;
}

Location place(const std::string& text, std::size_t at,
               const std::string& file) {
    const auto begin = text.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(at);
    const std::size_t line_end = text.rfind('\n', at);
    return {file, 1 + static_cast<int>(std::count(begin, end, '\n')),
            static_cast<int>(at - line_end)};
}

std::string line_of(const std::string& text, std::uint32_t number) {
    std::size_t begin = 0;
    for (std::uint32_t i = 1; i < number; ++i)
        begin = text.find('\n', begin) + 1;
    return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

//! Returns the parser's message in the style of the other messages.
std::string reason(const toml::parse_error& error) {
    std::string text(error.description());
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(text[0]));
    // toml++ 3.3 gives a wrong limit of hours in its message.
    const std::string wrong = "hour between 0 to 59";
    if (const std::size_t at = text.find(wrong); at != std::string::npos)
        text.replace(at, wrong.size(), "hour between 0 and 23");
    return text;
}

//! Returns the problem of a line, with its reason and a remedy.
std::string problem(const toml::parse_error& error, const std::string& line) {
    const std::string why = reason(error);
    const bool is_twice = why.find("cannot redefine") != std::string::npos;
    const bool is_table =
        why.find("table '") != std::string::npos || why.ends_with("as table");
    if (is_twice && is_table && why.find("bounds'") != std::string::npos)
        return "plant.bounds is given twice (as a rule and as a table); keep "
               "either bounds = \"...\" or [plant.bounds]";
    return fmt::format("not valid TOML ({}); {}", why,
                       is_twice ? "remove one of the two" : line_advice(line));
}

}  // namespace

std::optional<toml::table> parse_toml(const std::string& text,
                                      const std::string& file,
                                      const Problems& problems) {
    problems.open(file);
    if (const auto at = find_deep_key(text)) {
        problems.add(
            place(text, *at, file),
            fmt::format("a key has more than {} parts (joined by dots, "
                        "the keys of a campaign have at most 4); "
                        "correct this line",
                        most_parts));
        return std::nullopt;
    }
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        problems.add(location(error.source(), file),
                     problem(error, line_of(text, error.source().begin.line)));
        return std::nullopt;
    }
}

}  // namespace ideotype
