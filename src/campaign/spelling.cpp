// SPDX-License-Identifier: Apache-2.0
#include "spelling.hpp"

#include <algorithm>
#include <regex>

#include <fmt/format.h>

namespace ideotype {

namespace {

//! The parts of a short text that matches a pattern; else none. Regular
//! expressions take too much stack for long ones.
std::smatch parts(const std::string& text, const std::string& pattern) {
    constexpr std::size_t longest = 200;
    std::smatch found;
    if (text.size() <= longest)
        std::regex_match(text, found, std::regex(pattern));
    return found;
}

int to_int(const std::ssub_match& digits) {
    return digits.matched ? std::stoi(digits.str()) : 0;
}

}  // namespace

std::optional<std::string> meant_time(const std::string& text) {
    const std::smatch found =
        parts(text, R"((\d{1,2}):([0-5]\d)(?::([0-5]\d))?)");
    if (found.empty() || to_int(found[1]) > 23) return std::nullopt;
    return fmt::format("{:02}:{:02}:{:02}", to_int(found[1]), to_int(found[2]),
                       to_int(found[3]));
}

bool is_midnight(const std::string& text) {
    return text == "24:00" || text == "24:00:00";
}

std::optional<std::string> meant_date(const std::string& text) {
    std::smatch found = parts(text, R"((\d{4})[-./](\d{1,2})[-./](\d{1,2}))");
    const bool is_year_first = !found.empty();
    if (!is_year_first) found = parts(text, R"((\d{1,2})\.(\d{1,2})\.(\d{4}))");
    if (found.empty()) return std::nullopt;
    const int year = to_int(found[is_year_first ? 1 : 3]);
    const int month = to_int(found[2]);
    const int day = to_int(found[is_year_first ? 3 : 1]);
    if (month < 1 || month > 12 || day < 1 || day > 31) return std::nullopt;
    return fmt::format("{:04}-{:02}-{:02}", year, month, day);
}

std::optional<std::string> meant_number(const std::string& text) {
    const std::smatch found =
        parts(text, R"(\+?(-?)(\d*)[.,]?(\d*)\s*(?:m|h|deg|min|s)?)");
    if (found.empty()) return std::nullopt;
    std::string whole = found[2], decimals = found[3];
    if (whole.empty() && decimals.empty()) return std::nullopt;
    whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size()));
    if (whole.empty()) whole = "0";
    if (!decimals.empty()) decimals.insert(0, ".");
    return found[1].str() + whole + decimals;
}

std::string line_advice(const std::string& line) {
    const std::smatch found =
        parts(line, R"(\s*([\w-]+)\s*=\s*([^#]*[^#\s])\s*(?:#.*)?)");
    if (found.empty()) return "correct this line";
    const std::string key = found[1], value = found[2];
    if (is_midnight(value))
        return fmt::format("write the end of a day as in {} = \"24:00\"", key);
    if (const auto time = meant_time(value); time && *time != value)
        return fmt::format("write times as in {} = {}", key, *time);
    if (const auto date = meant_date(value); date && *date != value)
        return fmt::format("write dates as in {} = {}", key, *date);
    if (const auto number = meant_number(value); number && *number != value)
        return fmt::format("write numbers as in {} = {}", key, *number);
    if (!parts(value, R"([A-Za-z][\w./ -]*)").empty())
        return fmt::format("write texts as in {} = \"{}\"", key, value);
    return "correct this line";
}

}  // namespace ideotype
