// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/clock.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/text.hpp"

namespace ideotype {

namespace {

//! Largest number of digits, enough for the seconds of any job.
constexpr std::size_t most_digits = 9;

std::optional<double> parse_clock(Scanner text) {
    const auto hours = text.number(1, most_digits);
    if (!hours || !text.take(":")) return {};
    const auto minutes = text.number(2, 2);
    if (!minutes || *minutes > 59 || !text.take(":")) return {};
    const auto seconds = text.number(2, 2);
    if (!seconds || *seconds > 59 || !text.is_at_end()) return {};
    return 3600.0 * *hours + 60 * *minutes + *seconds;
}

}  // namespace

std::optional<double> parse_duration(const std::string& text) {
    if (const auto clock = parse_clock(Scanner(text))) return clock;
    if (text.empty()) return {};
    Scanner rest(text);
    double sum = 0;
    auto count = rest.number(1, most_digits);
    for (const auto& [unit, seconds] : {std::pair{"h", 3600.0}, {"m", 60.0}})
        if (count && rest.take(unit)) {
            sum += *count * seconds;
            count = rest.number(1, most_digits);
        }
    if (count) rest.take("s");
    if (!rest.is_at_end()) return {};
    return sum + count.value_or(0);
}

std::string clock_name(double utc_offset) {
    IDEOTYPE_EXPECT(std::isfinite(utc_offset));
    const long minutes = std::lround(std::abs(utc_offset) * 60);
    if (minutes == 0) return "UTC";
    return fmt::format(
        "UTC{}{}{}", utc_offset < 0 ? '-' : '+', minutes / 60,
        minutes % 60 == 0 ? "" : fmt::format(":{:02}", minutes % 60));
}

std::string clock_time(double hour) {
    IDEOTYPE_EXPECT(hour >= -24 && hour < 48);
    constexpr long day = 24 * 60;
    const long minutes = (std::lround(hour * 60) + day) % day;
    return fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
}

}  // namespace ideotype
