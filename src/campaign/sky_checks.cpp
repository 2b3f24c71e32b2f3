// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/clock.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

void check_site(const Site& site, Problems& problems) {
    if (!problems.usable({&site.longitude, &site.utc_offset})) return;
    // Real clocks are within four hours of the sun, summer time included, and
    // few are more than two off.
    constexpr double unusual = 2, impossible = 4;
    const double ahead = clock_ahead(site);
    if (std::abs(ahead) <= unusual) return;
    const std::string what = fmt::format(
        "site.utc_offset is {} h (the clock would be {:.1f} h {} the sun's at "
        "longitude {} deg)",
        site.utc_offset, std::abs(ahead), ahead > 0 ? "ahead of" : "behind",
        site.longitude);
    if (std::abs(ahead) > impossible)
        problems.add(&site.utc_offset,
                     what + "; check the signs: east is positive in both");
    else
        problems.warn(&site.utc_offset,
                      what + "; check both, few places have such a clock");
}

void check_day(const DaySpan& day, Problems& problems) {
    if (!problems.usable({&day.start, &day.end})) return;
    if (day.end <= day.start)
        return problems.add(
            &day.end, fmt::format("day.end is {} (not after the start at "
                                  "{}); give a later end",
                                  clock_text(day.end), clock_text(day.start)));
    if (!problems.usable({&day.step_minutes})) return;
    const double span = (day.end - day.start) * 60;
    const double steps = span / day.step_minutes;
    const double instants = steps * static_cast<double>(day.dates.size());
    constexpr double most = 1e6;
    if (instants > most)
        return problems.add(
            &day.step_minutes,
            fmt::format(
                "day.step_minutes is {} min (with {} dates that is "
                "{:.0f} instants, the limit is {:.0f}); use fewer dates "
                "or a longer step",
                day.step_minutes, day.dates.size(), instants, most));
    if (std::abs(steps - std::round(steps)) < 1e-6 && steps > 0.5) return;
    const double fewer = std::max(1.0, std::floor(steps));
    problems.add(
        &day.step_minutes,
        fmt::format("day.step_minutes is {} min (does not divide the "
                    "{:.6g} min from start to end); use {:.6g} or "
                    "{:.6g}",
                    day.step_minutes, span, span / (fewer + 1), span / fewer));
}

void check_light(const Site& site, const Named<DaySpan>& day,
                 Problems& problems) {
    const DaySpan& span = day.value;
    if (!problems.usable({&site.latitude, &site.longitude, &site.utc_offset,
                          &site.elevation, &site.linke_turbidity, &span.dates,
                          &span.start, &span.end, &span.step_minutes}) ||
        clear_days(site, span, 1).incident() > 0)
        return;
    const Daylight sun = daylight(site, span.dates[0]);
    const std::string what = fmt::format(
        "day \"{}\" has no light at site \"{}\" ", day.name, site.name);
    if (sun.sunrise && sun.sunset)
        problems.add(
            problems.where(&span.start),
            what + fmt::format("(the sun is up from {} to {}); give a start "
                               "and an end within, or a shorter step",
                               clock_time(*sun.sunrise),
                               clock_time(*sun.sunset)));
    else
        problems.add(problems.where(&span.dates),
                     what +
                         "(the sun is down all day); take another date or "
                         "site");
}

double total(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

void check_sky(const Campaign& campaign, Problems& problems) {
    for (const Site& site : campaign.sites) check_site(site, problems);
    for (const Named<DaySpan>& day : campaign.days)
        check_day(day.value, problems);
    for (const Site& site : campaign.sites)
        for (const Named<DaySpan>& day : campaign.days)
            check_light(site, day, problems);
    if (campaign.climates.empty()) return;
    const std::string& climate = campaign.climates[0].name;
    if (!campaign.days.empty())
        problems.add(
            problems.where(&climate),
            "there are both [[climate]] and [[day]] (each case has one "
            "of them); remove one, or write two campaigns");
    for (const SiteWeather& weather : campaign.weathers)
        if (problems.empty() &&
            !(total(weather.beam) + total(weather.diffuse) > 0))
            problems.add(problems.where(&climate),
                         fmt::format("climate \"{}\" has no light at site "
                                     "\"{}\"; take another period",
                                     weather.climate, weather.site));
}

}  // namespace ideotype
