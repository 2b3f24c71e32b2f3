// SPDX-License-Identifier: Apache-2.0
#include "nodes.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "spelling.hpp"

namespace ideotype {

namespace {

constexpr std::size_t longest_name = 64;

// Names contain only ASCII characters, so that they work as file names on any
// system.
bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           (c >= '0' && c <= '9');
}

bool is_allowed(char c) {
    return is_letter_or_digit(c) || c == '_' || c == '-';
}

//! The largest number of parts of a key; campaigns need four. The parser calls
//! itself for each part, and limits only the depth of nested values.
constexpr int most_parts = 8;

//! Returns the end of the comment or string that begins at a position.
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

//! Returns the position of a key with too many parts.
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

//! Returns the parser's message, in the style of other messages.
std::string reason(const toml::parse_error& error) {
    std::string text(error.description());
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(text[0]));
    // toml++ 3.3 gives a wrong limit of hours in its message.
    const std::string wrong = "hour between 0 to 59";
    if (const std::size_t at = text.find(wrong); at != std::string::npos)
        text.replace(at, wrong.size(), "hour between 0 and 23");
    return text;
}

//! Describes the problem of a line, with a remedy.
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

std::optional<toml::table> parsed(const std::string& text,
                                  const std::string& name) {
    try {
        return toml::parse(text, name);
    } catch (const toml::parse_error&) {
        return std::nullopt;
    }
}

//! Returns a table that contains only the key of a setting.
std::optional<toml::table> read(const std::string& setting,
                                const std::string& name) {
    const std::size_t end = setting.find('=');
    if (end == std::string::npos) return std::nullopt;
    const std::string key = setting.substr(0, end);
    const std::string value = setting.substr(end + 1);
    if (std::count(key.begin(), key.end(), '.') > most_parts ||
        setting.find('\n') != std::string::npos)
        return std::nullopt;
    if (auto table = parsed(key + " = " + value, name)) return table;
    std::string quoted;
    for (const char c : value) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return parsed(key + " = \"" + quoted + '"', name);
}

//! Inserts the value of a setting into a campaign. The parts of the setting's
//! key lead to the old value, which is replaced as a whole.
struct Replacer {
    const std::string& name;
    const Problems& problems;
    bool is_refused = false;

    void replace(toml::table& into, toml::table& setting,
                 const std::string& path) {
        for (auto&& [key, node] : setting) {
            const std::string inner =
                path.empty() ? std::string(key.str())
                             : fmt::format("{}.{}", path, key.str());
            toml::table* const given = node.as_table();
            toml::table* const known =
                given ? table_at(into[key.str()].node(), inner) : nullptr;
            // Tables in braces are values; other tables represent parts of a
            // key.
            if (known && !given->is_inline())
                replace(*known, *given, inner);
            else if (!is_refused)
                // A moved node keeps its source position.
                node.visit([&, at = key](auto& value) {
                    into.insert_or_assign(at, std::move(value));
                });
        }
    }

    //! Returns the table itself, or the only table of a list.
    toml::table* table_at(toml::node* node, const std::string& path) {
        if (!node) return nullptr;
        if (toml::table* const table = node->as_table()) return table;
        toml::array* const list = node->as_array();
        if (!list || !list->is_homogeneous<toml::table>()) return nullptr;
        if (list->size() == 1) return list->front().as_table();
        is_refused = true;
        problems.add_at(Location{name}, path, ProblemCode::syntax,
                        "there are {} tables [[{}]] (it is not clear which one "
                        "is meant); change the file",
                        list->size(), path);
        return nullptr;
    }
};

}  // namespace

Location location(const toml::source_region& source, const std::string& file) {
    if (source.path && source.path->starts_with(command_line_mark))
        return {*source.path};
    // The root table has no line; line 1 stands for it.
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

std::string toml_of(const toml::node& node) {
    if (const auto* number = node.as_floating_point())
        return fmt::format("{}", number->get());
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    std::string line = text.str();
    std::ranges::replace(line, '\n', ' ');
    return line;
}

bool is_name(const std::string& text) {
    // A leading dash would look like an option.
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

std::optional<toml::table> parse_toml(const std::string& text,
                                      const std::string& file,
                                      const Problems& problems) {
    problems.open(file);
    if (const auto at = find_deep_key(text)) {
        problems.add_at(place(text, *at, file), "", ProblemCode::syntax,
                        "a key has more than {} parts (keys of a campaign have "
                        "at most 4, joined by dots); correct this line",
                        most_parts);
        return std::nullopt;
    }
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        problems.add_at(
            location(error.source(), file), "", ProblemCode::syntax, "{}",
            problem(error, line_of(text, error.source().begin.line)));
        return std::nullopt;
    }
}

void apply_settings(const std::vector<std::string>& settings,
                    toml::table& campaign, const Problems& problems) {
    for (const std::string& setting : settings) {
        const std::string name = std::string(command_line_mark) + setting;
        problems.open(name);
        if (auto table = read(setting, name))
            Replacer{name, problems}.replace(campaign, *table, "");
        else
            problems.add_at(Location{name}, "", ProblemCode::syntax,
                            "this is not a key with a value; write for example "
                            "--set search.optimizer=random");
    }
}

}  // namespace ideotype
