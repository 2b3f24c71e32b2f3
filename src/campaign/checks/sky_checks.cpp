// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/clock.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

void check_site(const Site& site, const Problems& problems) {
    // Real clocks differ from solar time by at most four hours, including
    // summer time. Few differ by more than two.
    constexpr double unusual = 2, impossible = 4;
    const double ahead = clock_ahead(site);
    const std::string fault = fmt::format(
        "site.utc_offset is {} h (the clock would be {:.1f} h {} the sun's at "
        "longitude {} deg)",
        site.utc_offset, std::abs(ahead), ahead > 0 ? "ahead of" : "behind",
        site.longitude);
    const Keys keys{"utc_offset", "longitude"};
    problems.rule(keys, std::abs(ahead) > impossible,
                  "{}; check the signs: east is positive in both", fault);
    problems.doubt(keys, std::abs(ahead) > unusual,
                   "{}; check both, few places have such a clock", fault);
}

//! Describes the fault of a step [min] that does not divide the span of the
//! day.
std::string fault_of_step(double step_minutes, double span) {
    const double steps = span / step_minutes;
    if (std::abs(steps - std::round(steps)) < 1e-6 && steps > 0.5) return "";
    // A step in minutes is a short decimal number if it is a multiple of 3 s.
    const long ticks = std::lround(span * 20);
    const auto step = [&](long count, long change) {
        while (count > 1 && count < ticks && ticks % count != 0)
            count += change;
        return span / static_cast<double>(count);
    };
    const long fewer = std::max(1L, static_cast<long>(steps));
    return fmt::format(
        "day.step_minutes is {} min (does not divide the {:.6g} min from start "
        "to end); use {:.6g} or {:.6g}",
        step_minutes, span, step(fewer + 1, 1), step(fewer, -1));
}

void check_day(const DaySpan& day, const Problems& problems) {
    const double span = (day.end - day.start) * 60;
    const double instants =
        span / day.step_minutes * static_cast<double>(day.dates.size());
    constexpr double limit = 1e6;
    problems.rule({"end", "start"}, day.end <= day.start,
                  "day.end is {} (not after the start at {}); give a later end",
                  clock_text(day.end), clock_text(day.start));
    problems.rule(
        {"step_minutes", "start", "end"}, instants > limit,
        "day.step_minutes is {} min (with {} dates that is {:.0f} instants, "
        "the limit is {:.0f}); use fewer dates or a longer step",
        day.step_minutes, day.dates.size(), instants, limit);
    problems.rule({"step_minutes", "start", "end"},
                  [&] { return fault_of_step(day.step_minutes, span); });
}

void check_light(const Site& site, const Named<DaySpan>& day,
                 const Problems& of_site, const Problems& of_day) {
    const DaySpan& span = day.value;
    if (!of_site.usable({"latitude", "longitude", "utc_offset", "elevation",
                         "linke_turbidity"}) ||
        !of_day.usable({"date", "start", "end", "step_minutes"}) ||
        clear_days(site, span, 1).incident() > 0)
        return;
    const Daylight sun = daylight(site, span.dates[0]);
    const std::string fault = fmt::format(
        "day \"{}\" has no light at site \"{}\" ", day.name, site.name);
    if (sun.sunrise && sun.sunset)
        of_day.add_at(of_day.where("start"), "start",
                      ProblemCode::contradiction,
                      "{}(the sun is up from {} to {}); give a start and an "
                      "end within, or a shorter step",
                      fault, clock_time(*sun.sunrise), clock_time(*sun.sunset));
    else
        of_day.add_at(of_day.where("date"), "date", ProblemCode::contradiction,
                      "{}(the sun is down all day); take another date or site",
                      fault);
}

double total(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

void check_sky(const Spec& spec, const Problems& problems) {
    const std::vector<Site>& sites = spec.sites;
    const std::vector<Named<DaySpan>>& days = spec.days;
    for (std::size_t s = 0; s < sites.size(); ++s)
        check_site(sites[s], problems.in("site", s));
    for (std::size_t d = 0; d < days.size(); ++d)
        check_day(days[d].value, problems.in("day", d));
    for (std::size_t s = 0; s < sites.size(); ++s)
        for (std::size_t d = 0; d < days.size(); ++d)
            check_light(sites[s], days[d], problems.in("site", s),
                        problems.in("day", d));
    if (spec.climates.empty()) return;
    if (!days.empty())
        problems.add("climate[0].name", ProblemCode::contradiction,
                     "there are both [[climate]] and [[day]] (each case has "
                     "one of them); remove one, or write two campaigns");
    for (const SiteWeather& weather : spec.weathers)
        problems.rule(
            {"climate[0].name"},
            problems.empty() &&
                !(total(weather.beam[0]) + total(weather.diffuse[0]) > 0),
            "climate \"{}\" has no light at site \"{}\"; take another period",
            weather.climate, weather.site);
}

}  // namespace ideotype
