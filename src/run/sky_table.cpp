// SPDX-License-Identifier: Apache-2.0
#include "sky_table.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/air.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/clock.hpp"

namespace ideotype {

namespace {

std::string clock(std::optional<double> hour) {
    return hour ? clock_time(*hour) : "-";
}

const Date& middle(const std::vector<Date>& dates) {
    return dates[dates.size() / 2];
}

std::string place(const Site& site) {
    return fmt::format("{} {} {} {}", std::abs(site.latitude),
                       site.latitude < 0 ? 'S' : 'N', std::abs(site.longitude),
                       site.longitude < 0 ? 'W' : 'E');
}

}  // namespace

void print_warnings(const Campaign& campaign, const Log& log) {
    for (const Problem& warning : campaign.warnings)
        log.write(LogLevel::warning, to_string(warning));
}

namespace {

std::string table_of_days(const Campaign& campaign) {
    constexpr auto row =
        "{:<9} {:<12} {:<16} {:<6} {:<8} {:>7} {:>5} {:>9} {:>6} "
        "{:>8} {:>11}\n";
    std::string text =
        fmt::format(row, "sun", "site", "place", "day", "clock", "sunrise",
                    "noon", "elevation", "sunset", "left out", "clock ahead");
    for (const Site& site : campaign.sites)
        for (const auto& [name, span] : campaign.days) {
            const Daylight sun = daylight(site, middle(span.dates));
            text += fmt::format(
                row, "", site.name, place(site), name,
                clock_name(site.utc_offset), clock(sun.sunrise),
                clock(sun.noon), fmt::format("{:.1f} deg", sun.elevation),
                clock(sun.sunset),
                fmt::format("{:.1f} %", 100 * share_left_out(site, span)),
                fmt::format("{:+.2f} h", clock_ahead(site)));
        }
    return text;
}

//! The mean of what is known by day, weighted by light.
std::string by_day(const LightSeries& series,
                   std::optional<double> TimeStep::*value, double factor,
                   const std::string& unit) {
    double sum = 0, light = 0;
    for (const TimeStep& step : series.steps) {
        const double par = step.par.beam + step.par.diffuse;
        if (!(step.*value)) return "-";
        sum += par * *(step.*value);
        light += par;
    }
    return fmt::format("{:.1f} {}", factor * sum / light, unit);
}

//! What the air has besides, of a case whose weather tells any of it.
std::string air_of(const Campaign& campaign, const Case& one,
                   LightSeries series) {
    const LightSeries without;
    const TimeStep& first = series.steps.front();
    if (!first.wind && !first.pressure && !first.longwave &&
        series.co2 == without.co2)
        return "";
    const std::vector<std::string> estimated =
        estimate_air(series, one.site, campaign.par_fraction);
    const auto mean = [&](std::optional<double> TimeStep::*value) {
        double sum = 0;
        for (const TimeStep& step : series.steps) sum += *(step.*value);
        return sum / static_cast<double>(series.steps.size());
    };
    return fmt::format(
        "          {} at {}: wind {:.1f} m/s at {:g} m, pressure {:.1f} kPa, "
        "longwave radiation {:.0f} W m-2, CO2 {:g} umol mol-1{}\n",
        one.day_name, one.site.name, mean(&TimeStep::wind), series.wind_height,
        mean(&TimeStep::pressure), mean(&TimeStep::longwave), series.co2,
        estimated.empty() ? ""
                          : fmt::format(" (not in the file and estimated: {})",
                                        fmt::join(estimated, ", ")));
}

std::string table_of_climates(const Campaign& campaign) {
    constexpr auto row =
        "{:<9} {:<12} {:<16} {:<10} {:>4} {:>11} {:>8} {:>11} {:>8} {:<8} "
        "{:>7} "
        "{:>5} {:>6}\n";
    std::string text =
        fmt::format(row, "climate", "site", "place", "period", "days",
                    "PAR per day", "diffuse", "temperature", "humidity",
                    "clock", "sunrise", "noon", "sunset");
    std::string air;
    for (const Case& one : cases(campaign))
        for (const Case& each : scenarios(one)) {
            const Site& site = each.site;
            const std::string start =
                fmt::format("{:<9} {:<12} {:<16} {:<10} ", "", site.name,
                            place(site), each.day_name);
            if (text.find(start) != std::string::npos) continue;
            const LightSeries series = light_of(campaign, each);
            air += air_of(campaign, each, series);
            const Daylight sun = daylight(site, middle(series.dates()));
            text += fmt::format(
                row, "", site.name, place(site), each.day_name, series.days,
                fmt::format("{:.2f} MJ m-2", series.incident() / 1e6),
                fmt::format("{:.0f} %",
                            100 * series.diffuse() / series.incident()),
                by_day(series, &TimeStep::temperature, 1, "C"),
                by_day(series, &TimeStep::humidity, 100, "%"),
                clock_name(site.utc_offset), clock(sun.sunrise),
                clock(sun.noon), clock(sun.sunset));
        }
    return text +
           "          temperature and humidity are weighted by light; "
           "sunrise, noon and sunset are those of the middle date\n" +
           air;
}

}  // namespace

std::string sky_table(const Campaign& campaign) {
    return campaign.climates.empty() ? table_of_days(campaign)
                                     : table_of_climates(campaign);
}

}  // namespace ideotype
