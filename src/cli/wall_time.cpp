#include "ideotype/cli/wall_time.hpp"

#include <regex>

namespace ideotype {

namespace {

double number(const std::ssub_match& part) {
    return part.matched ? std::stod(part) : 0;
}

}  // namespace

std::optional<double> parse_wall_time(const std::string& text) {
    // Nine digits are more than any job lasts.
    static const std::regex clock(R"((\d{1,9}):([0-5]\d):([0-5]\d))");
    static const std::regex units(
        R"((?:(\d{1,9})h)?(?:(\d{1,9})m)?(?:(\d{1,9})s?)?)");
    std::smatch match;
    if (!std::regex_match(text, match, clock) &&
        !std::regex_match(text, match, units))
        return std::nullopt;
    const double seconds =
        3600 * number(match[1]) + 60 * number(match[2]) + number(match[3]);
    return seconds > 0 ? std::optional(seconds) : std::nullopt;
}

}  // namespace ideotype
