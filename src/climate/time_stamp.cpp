// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "weather_table.hpp"

namespace ideotype {

using namespace std::chrono;

ClockTime midnight(const Date& date) {
    return ClockTime{to_day(date).time_since_epoch()};
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

namespace {

//! Returns the first instant of a date, or nothing if there is no such date.
std::optional<ClockTime> midnight(int year, int month, int day) {
    if (month < 1 || month > 12 || day < 1 || day > 31) return std::nullopt;
    const Date date{year, month, day};
    if (date_at(midnight(date)) != date) return std::nullopt;
    return midnight(date);
}

//! Parses whole numbers of up to four digits between separators of one kind;
//! returns nothing for any other text.
std::vector<int> parse_numbers(std::string_view text,
                               std::string_view separators) {
    const std::size_t first = text.find_first_of(separators);
    const char separator = first == text.npos ? '\0' : text[first];
    std::vector<int> values;
    for (;;) {
        const std::size_t end = text.find(separator);
        const std::string_view part = text.substr(0, end);
        if (part.empty() || part.size() > 4 ||
            part.find_first_not_of("0123456789") != part.npos)
            return {};
        values.push_back(static_cast<int>(*parse_number(part)));
        if (end == text.npos) return values;
        text.remove_prefix(end + 1);
    }
}

std::optional<ClockTime> parse_date(std::string_view text, DateOrder order) {
    std::string parted(text);
    if (order == DateOrder::year_month_day && text.size() == 8 &&
        text.find_first_of("-/.") == text.npos)
        parted.insert(6, "-").insert(4, "-");
    std::vector<int> parts = parse_numbers(parted, "-/.");
    if (parts.size() != 3) return std::nullopt;
    if (order == DateOrder::month_day_year)
        parts = {parts[2], parts[0], parts[1]};
    if (order == DateOrder::day_month_year)
        parts = {parts[2], parts[1], parts[0]};
    if (parts[0] < 1000) return std::nullopt;
    return midnight(parts[0], parts[1], parts[2]);
}

std::optional<double> parse_clock(std::string_view text) {
    std::vector<int> parts = parse_numbers(text, ":");
    if (parts.size() == 1 && text.size() == 4)
        parts = {parts[0] / 100, parts[0] % 100};
    if (parts.size() != 2 && parts.size() != 3) return std::nullopt;
    parts.resize(3);
    const double hours = parts[0] + parts[1] / 60.0 + parts[2] / 3600.0;
    if (hours > 24 || parts[1] > 59 || parts[2] > 59) return std::nullopt;
    return hours;
}

//! Parses an offset from UTC such as -06:00, +0530 or Z [h].
std::optional<double> parse_offset(std::string_view text) {
    if (text == "Z" || text == "z") return 0;
    if (text.size() < 2) return std::nullopt;
    const double sign = text.front() == '-' ? -1 : 1;
    text.remove_prefix(1);
    const std::optional<double> hours =
        text.size() == 2 ? parse_number(text) : parse_clock(text);
    if (!hours) return std::nullopt;
    return sign * *hours;
}

std::optional<WrittenTime> parse_text(std::string_view text, DateOrder order) {
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

}  // namespace

std::optional<WrittenTime> parse_time(const std::vector<CsvField>& parts,
                                      DateOrder order) {
    if (parts.size() == 1) return parse_text(parts[0].text, order);
    const auto sum = [](std::optional<ClockTime> date,
                        std::optional<double> hours) {
        return date && hours
                   ? std::optional(WrittenTime{later(*date, *hours), {}})
                   : std::nullopt;
    };
    if (parts.size() == 2)
        return sum(parse_date(parts[0].text, order),
                   parse_clock(parts[1].text));
    // The date and the clock time are given as columns of numbers.
    std::array<double, 5> values{};
    for (std::size_t i = 0; i < parts.size() && i < values.size(); ++i) {
        const auto number = parse_number(parts[i].text);
        if (!number || !(std::abs(*number) <= 9999) ||
            (i < 3 && *number != std::trunc(*number)))
            return std::nullopt;
        values[i] = *number;
    }
    const auto whole = [&](std::size_t i) {
        return static_cast<int>(values[i]);
    };
    const double hours = values[3] + values[4] / 60;
    if (hours < 0 || hours > 24) return std::nullopt;
    return sum(midnight(whole(0), whole(1), whole(2)), hours);
}

}  // namespace ideotype
