// SPDX-License-Identifier: Apache-2.0
#include "time_stamp.hpp"

#include <array>
#include <cmath>
#include <string>

#include "ideotype/core/csv.hpp"

namespace ideotype {

namespace {

using namespace std::chrono;

constexpr std::string_view digits = "0123456789";

bool only_digits(std::string_view text) {
    return !text.empty() && text.find_first_not_of(digits) == text.npos;
}

//! A whole number of few digits.
std::optional<int> whole(std::string_view text) {
    if (!only_digits(text) || text.size() > 4) return std::nullopt;
    return static_cast<int>(*number_of(text));
}

//! The hours of an offset from UTC, such as -06:00, +0530 or Z.
std::optional<double> parse_offset(std::string_view text) {
    if (text == "Z" || text == "z") return 0;
    if (text.size() < 2) return std::nullopt;
    const double sign = text.front() == '-' ? -1 : 1;
    text.remove_prefix(1);
    const std::optional<double> hours =
        text.size() == 2 ? number_of(text) : parse_clock(text);
    if (!hours) return std::nullopt;
    return sign * *hours;
}

}  // namespace

std::optional<ClockTime> midnight(int year, int month, int day) {
    if (month < 1 || month > 12 || day < 1 || day > 31) return std::nullopt;
    const year_month_day date{std::chrono::year{year},
                              std::chrono::month(static_cast<unsigned>(month)),
                              std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok()) return std::nullopt;
    return ClockTime{local_days{date}};
}

ClockTime midnight(const Date& date) {
    return midnight(date.year, date.month, date.day).value();
}

Date date_at(ClockTime time) {
    const year_month_day date{floor<days>(time)};
    return {static_cast<int>(date.year()),
            static_cast<int>(static_cast<unsigned>(date.month())),
            static_cast<int>(static_cast<unsigned>(date.day()))};
}

double hour_at(ClockTime time) {
    return static_cast<double>((time - floor<days>(time)).count()) / 3600;
}

ClockTime later(ClockTime time, double hours) {
    return time + seconds{std::llround(hours * 3600)};
}

std::optional<ClockTime> parse_date(std::string_view text, DateOrder order) {
    std::array<std::string_view, 3> parts;
    if (only_digits(text) && text.size() == 8 &&
        order == DateOrder::year_month_day) {
        parts = {text.substr(0, 4), text.substr(4, 2), text.substr(6)};
    } else {
        const std::size_t first = text.find_first_not_of(digits);
        if (first == text.npos) return std::nullopt;
        const std::size_t second = text.find(text[first], first + 1);
        if (std::string_view("-/.").find(text[first]) == text.npos ||
            second == text.npos)
            return std::nullopt;
        parts = {text.substr(0, first),
                 text.substr(first + 1, second - first - 1),
                 text.substr(second + 1)};
    }
    if (order == DateOrder::month_day_year)
        parts = {parts[2], parts[0], parts[1]};
    if (order == DateOrder::day_month_year)
        parts = {parts[2], parts[1], parts[0]};
    const std::optional<int> year = whole(parts[0]);
    const std::optional<int> month = whole(parts[1]);
    const std::optional<int> day = whole(parts[2]);
    if (!year || !month || !day || parts[0].size() != 4) return std::nullopt;
    return midnight(*year, *month, *day);
}

std::optional<double> parse_clock(std::string_view text) {
    std::array<int, 3> parts{};
    if (text.size() == 4 && only_digits(text)) {
        parts = {*whole(text.substr(0, 2)), *whole(text.substr(2)), 0};
    } else {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::size_t end = text.find(':');
            const std::optional<int> part = whole(text.substr(0, end));
            if (!part || end + 1 == text.size()) return std::nullopt;
            parts[i] = *part;
            if (end == text.npos) {
                if (i == 0) return std::nullopt;
                text = {};
                break;
            }
            text.remove_prefix(end + 1);
        }
        if (!text.empty()) return std::nullopt;
    }
    const double hours = parts[0] + parts[1] / 60.0 + parts[2] / 3600.0;
    if (hours > 24 || parts[1] > 59 || parts[2] > 59) return std::nullopt;
    return hours;
}

std::optional<WrittenTime> parse_time(std::string_view text, DateOrder order) {
    const std::size_t between = text.find_first_of("Tt ");
    if (between == text.npos) return std::nullopt;
    const std::optional<ClockTime> date =
        parse_date(text.substr(0, between), order);
    std::string_view clock = text.substr(between + 1);
    WrittenTime written;
    if (const std::size_t end = clock.find_first_of("Zz+-");
        end != clock.npos) {
        written.utc_offset = parse_offset(clock.substr(end));
        if (!written.utc_offset) return std::nullopt;
        clock = clock.substr(0, end);
    }
    const std::optional<double> hours = parse_clock(clock);
    if (!date || !hours) return std::nullopt;
    written.time = later(*date, *hours);
    return written;
}

}  // namespace ideotype
