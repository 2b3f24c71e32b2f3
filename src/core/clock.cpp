// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/clock.hpp"

#include <cmath>
#include <regex>

#include <fmt/format.h>

namespace ideotype {

namespace {

double number(const std::ssub_match& part) {
    return part.matched ? std::stod(part) : 0;
}

}  // namespace

std::optional<double> parse_duration(const std::string& text) {
    // Nine digits are more than any job lasts. Regular expressions take too
    // much stack for long texts.
    constexpr std::size_t longest = 40;
    static const std::regex clock(R"((\d{1,9}):([0-5]\d):([0-5]\d))");
    static const std::regex units(
        R"((?:(\d{1,9})h)?(?:(\d{1,9})m)?(?:(\d{1,9})s?)?)");
    std::smatch match;
    if (text.empty() || text.size() > longest ||
        (!std::regex_match(text, match, clock) &&
         !std::regex_match(text, match, units)))
        return std::nullopt;
    return 3600 * number(match[1]) + 60 * number(match[2]) + number(match[3]);
}

std::string clock_name(double utc_offset) {
    const long minutes = std::lround(std::abs(utc_offset) * 60);
    if (minutes == 0) return "UTC";
    return fmt::format(
        "UTC{}{}{}", utc_offset < 0 ? '-' : '+', minutes / 60,
        minutes % 60 == 0 ? "" : fmt::format(":{:02}", minutes % 60));
}

std::string clock_time(double hour) {
    constexpr long day = 24 * 60;
    const long minutes = (std::lround(hour * 60) + day) % day;
    return fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
}

}  // namespace ideotype
