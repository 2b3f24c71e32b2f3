#include "syntax.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

namespace ideotype {

namespace {

//! The first and one-past-last character of a line.
struct Span {
    std::size_t begin;
    std::size_t end;
};

Span find_line(const std::string& text, int line) {
    std::size_t begin = 0;
    for (int i = 1; i < line; ++i) begin = text.find('\n', begin) + 1;
    return {begin, std::min(text.find('\n', begin), text.size())};
}

//! Whether a line is a whole assignment, so that the lines after it make sense
//! without it.
bool is_assignment(const std::string& line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) return false;
    const std::string key = line.substr(0, equals);
    const bool is_plain = std::all_of(key.begin(), key.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) ||
               std::string_view("_-. \t").find(c) != std::string_view::npos;
    });
    const auto count = [&](char c) {
        return std::count(line.begin(), line.end(), c);
    };
    return is_plain && count('[') == count(']') && count('{') == count('}') &&
           line.find("\"\"\"") == std::string::npos &&
           line.find("'''") == std::string::npos;
}

//! What the parser says, in the style of the other messages.
std::string reason(const toml::parse_error& error) {
    std::string text(error.description());
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(text[0]));
    // toml++ 3.3 names the wrong limit of hours.
    const std::string wrong = "hour between 0 to 59";
    if (const std::size_t at = text.find(wrong); at != std::string::npos)
        text.replace(at, wrong.size(), "hour between 0 and 23");
    return text;
}

}  // namespace

std::optional<toml::table> parse_toml(std::string text, const std::string& file,
                                      Report& report) {
    int last_line = 0;
    while (true) {
        try {
            return toml::parse(text, file);
        } catch (const toml::parse_error& error) {
            const toml::source_position at = error.source().begin;
            const Location where{file, static_cast<int>(at.line),
                                 static_cast<int>(at.column)};
            const Span span = find_line(text, where.line);
            const std::string line =
                text.substr(span.begin, span.end - span.begin);
            const bool recovers = is_assignment(line);
            report.add(where,
                       fmt::format("not valid TOML ({}) {}", reason(error),
                                   recovers ? "correct this line"
                                            : "correct this line, then "
                                              "check the rest again"));
            if (!recovers) return std::nullopt;
            // An empty text keeps the key from being reported as missing; a
            // line that is wrong even so is left out.
            const std::string kept =
                line.substr(0, line.find('=') + 1) + " \"\"";
            text.replace(span.begin, line.size(),
                         where.line == last_line ? "" : kept);
            report.mute(file, where.line);
            last_line = where.line;
        }
    }
}

}  // namespace ideotype
