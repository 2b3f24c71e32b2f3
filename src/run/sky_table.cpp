#include "ideotype/run/sky_table.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "ideotype/climate/daylight.hpp"
#include "ideotype/core/clock.hpp"

namespace ideotype {

namespace {

std::string clock(std::optional<double> hour) {
    return hour ? clock_time(*hour) : "-";
}

std::string place(const Site& site) {
    return fmt::format("{} {} {} {}", std::abs(site.latitude),
                       site.latitude < 0 ? 'S' : 'N', std::abs(site.longitude),
                       site.longitude < 0 ? 'W' : 'E');
}

}  // namespace

void print_warnings(const Campaign& campaign) {
    for (const Problem& warning : campaign.warnings)
        fmt::print(stderr, "ideotype: warning: {}\n", to_string(warning));
}

std::string sky_table(const Campaign& campaign) {
    constexpr auto row =
        "{:<9} {:<12} {:<16} {:<6} {:>7} {:>5} {:>9} {:>6} "
        "{:>8} {:>11}\n";
    std::string text =
        fmt::format(row, "sun", "site", "place", "day", "sunrise", "noon",
                    "elevation", "sunset", "left out", "clock ahead");
    for (const Site& site : campaign.sites)
        for (const auto& [name, span] : campaign.days) {
            const Daylight sun = daylight(site, span.date);
            text += fmt::format(
                row, "", site.name, place(site), name, clock(sun.sunrise),
                clock(sun.noon), fmt::format("{:.1f} deg", sun.elevation),
                clock(sun.sunset),
                fmt::format("{:.1f} %", 100 * share_left_out(site, span)),
                fmt::format("{:+.2f} h", clock_ahead(site)));
        }
    return text;
}

}  // namespace ideotype
