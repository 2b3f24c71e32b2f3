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
    if (!problems.usable({"longitude", "utc_offset"})) return;
    // Real clocks differ from the sun by at most four hours, summer time
    // included, and few differ by more than two.
    constexpr double unusual = 2, impossible = 4;
    const double ahead = clock_ahead(site);
    if (std::abs(ahead) <= unusual) return;
    const std::string what = fmt::format(
        "site.utc_offset is {} h (the clock would be {:.1f} h {} the sun's at "
        "longitude {} deg)",
        site.utc_offset, std::abs(ahead), ahead > 0 ? "ahead of" : "behind",
        site.longitude);
    if (std::abs(ahead) > impossible)
        problems.add("utc_offset",
                     what + "; check the signs: east is positive in both");
    else
        problems.warn("utc_offset",
                      what + "; check both, few places have such a clock");
}

void check_day(const DaySpan& day, const Problems& problems) {
    if (!problems.usable({"start", "end"})) return;
    if (day.end <= day.start)
        return problems.add("end",
                            "day.end is {} (not after the start at {}); give a "
                            "later end",
                            clock_text(day.end), clock_text(day.start));
    if (!problems.usable({"step_minutes"})) return;
    const double span = (day.end - day.start) * 60;
    const double steps = span / day.step_minutes;
    const double instants = steps * static_cast<double>(day.dates.size());
    constexpr double most = 1e6;
    if (instants > most)
        return problems.add("step_minutes",
                            "day.step_minutes is {} min (with {} dates that is "
                            "{:.0f} instants, the limit is {:.0f}); use fewer "
                            "dates or a longer step",
                            day.step_minutes, day.dates.size(), instants, most);
    if (std::abs(steps - std::round(steps)) < 1e-6 && steps > 0.5) return;
    // Steps of whole multiples of 3 s are decimal numbers of minutes.
    const long ticks = std::lround(span * 20);
    const auto step = [&](long count, long change) {
        while (count > 1 && count < ticks && ticks % count != 0)
            count += change;
        return span / static_cast<double>(count);
    };
    const long fewer = std::max(1L, static_cast<long>(steps));
    problems.add("step_minutes",
                 "day.step_minutes is {} min (does not divide the {:.6g} min "
                 "from start to end); use {:.6g} or {:.6g}",
                 day.step_minutes, span, step(fewer + 1, 1), step(fewer, -1));
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
    const std::string what = fmt::format(
        "day \"{}\" has no light at site \"{}\" ", day.name, site.name);
    if (sun.sunrise && sun.sunset)
        of_day.add(of_day.where("start"),
                   "{}(the sun is up from {} to {}); give a start and an end "
                   "within, or a shorter step",
                   what, clock_time(*sun.sunrise), clock_time(*sun.sunset));
    else
        of_day.add(
            of_day.where("date"),
            what + "(the sun is down all day); take another date or site");
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
    const Location first = problems.in("climate", 0).where("name");
    if (!days.empty())
        problems.add(first,
                     "there are both [[climate]] and [[day]] (each case has "
                     "one of them); remove one, or write two campaigns");
    for (const SiteWeather& weather : spec.weathers)
        if (problems.empty() &&
            !(total(weather.beam[0]) + total(weather.diffuse[0]) > 0))
            problems.add(first,
                         "climate \"{}\" has no light at site \"{}\"; take "
                         "another period",
                         weather.climate, weather.site);
}

}  // namespace ideotype
