// SPDX-License-Identifier: Apache-2.0
#include "spelling.hpp"

#include <algorithm>
#include <chrono>
#include <string_view>

#include <fmt/format.h>

#include "ideotype/core/text.hpp"

namespace ideotype {

namespace {

constexpr std::string_view spaces = " \t\r\n\v\f", digits = "0123456789",
                           letters =
                               "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                               "abcdefghijklmnopqrstuvwxyz";

bool consists_of(std::string_view text, const std::string& characters) {
    return text.find_first_not_of(characters) == text.npos;
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
    return text.substr(0, text.find_last_not_of(spaces) + 1);
}

//! Formats a date as TOML; returns nothing if it is not in the calendar.
std::optional<std::string> date_of(int year, int month, int day) {
    const std::chrono::year_month_day date{
        std::chrono::year{year},
        std::chrono::month{static_cast<unsigned>(month)},
        std::chrono::day{static_cast<unsigned>(day)}};
    if (!date.ok()) return {};
    return fmt::format("{:04}-{:02}-{:02}", year, month, day);
}

}  // namespace

std::optional<std::string> meant_time(const std::string& text) {
    Scanner rest(text);
    const auto hour = rest.number(1, 2);
    if (!hour || *hour > 23 || !rest.take(":")) return {};
    const auto minute = rest.number(2, 2);
    if (!minute || *minute > 59) return {};
    std::optional<int> second = 0;
    if (rest.take(":")) second = rest.number(2, 2);
    if (!second || *second > 59 || !rest.is_at_end()) return {};
    return fmt::format("{:02}:{:02}:{:02}", *hour, *minute, *second);
}

bool is_midnight(const std::string& text) {
    return text == "24:00" || text == "24:00:00";
}

std::optional<std::string> meant_date(const std::string& text) {
    Scanner rest(text);
    const auto year = rest.number(4, 4);
    const auto first = year ? year : rest.number(1, 2);
    if (!first || !rest.take(year ? "-./" : ".")) return {};
    const auto month = rest.number(1, 2);
    if (!month || !rest.take(year ? "-./" : ".")) return {};
    const auto last = year ? rest.number(1, 2) : rest.number(4, 4);
    if (!last || !rest.is_at_end()) return {};
    return year ? date_of(*year, *month, *last)
                : date_of(*last, *month, *first);
}

std::optional<std::string> meant_number(const std::string& text) {
    constexpr std::string_view units[] = {"", "m", "h", "deg", "min", "s"};
    Scanner rest(text);
    rest.take("+");
    std::string number = rest.take("-") ? "-" : "";
    const auto whole = *rest.digits(0, text.size());
    rest.take(".,");
    const auto decimals = *rest.digits(0, text.size());
    if (whole.empty() && decimals.empty()) return {};
    const auto unit = trimmed(rest.rest());
    if (std::ranges::count(units, unit) == 0) return {};
    const auto significant =
        whole.substr(std::min(whole.find_first_not_of('0'), whole.size()));
    number += significant.empty() ? "0" : significant;
    if (!decimals.empty()) number.append(".").append(decimals);
    return number;
}

std::string line_advice(const std::string& line) {
    const auto content = std::string_view(line).substr(0, line.find('#'));
    const std::size_t equals = content.find('=');
    if (equals == content.npos) return "correct this line";
    const std::string key(trimmed(content.substr(0, equals)));
    const std::string value(trimmed(content.substr(equals + 1)));
    if (key.empty() || value.empty() ||
        !consists_of(key, fmt::format("{}{}_-", letters, digits)))
        return "correct this line";
    if (is_midnight(value))
        return fmt::format("write the end of a day as in {} = \"24:00\"", key);
    if (const auto time = meant_time(value); time && *time != value)
        return fmt::format("write times as in {} = {}", key, *time);
    if (const auto date = meant_date(value); date && *date != value)
        return fmt::format("write dates as in {} = {}", key, *date);
    if (const auto number = meant_number(value); number && *number != value)
        return fmt::format("write numbers as in {} = {}", key, *number);
    if (letters.find(value.front()) != letters.npos &&
        consists_of(value, fmt::format("{}{}_./ -", letters, digits)))
        return fmt::format("write texts as in {} = \"{}\"", key, value);
    return "correct this line";
}

}  // namespace ideotype
