// SPDX-License-Identifier: Apache-2.0
#include "ideotype/climate/light_series.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! Integrates a component of PAR over all steps; returns the mean per day [J
//! m-2].
double integrate_day(const LightSeries& series, double Irradiance::*component) {
    double sum = 0;
    for (const TimeStep& step : series.steps)
        sum += step.par.*component * step.seconds;
    return sum / series.days;
}

int count_steps(const DaySpan& span) {
    const double steps = (span.end - span.start) * 60 / span.step_minutes;
    const double whole = std::round(steps);
    if (!(whole >= 1) || !(std::abs(steps - whole) <= 1e-6))
        throw Error(
            "the time steps of a day do not fit between its start and end; "
            "choose a step that divides the time between them");
    return static_cast<int>(whole);
}

//! The elevation of the sun [deg] as a function of the time on the local clock.
class Elevation {
  public:
    Elevation(const Site& site, const Date& date) : site_(site), date_(date) {}

    double at(double hour) const {
        return 90 - sun_position(site_, date_, hour).zenith;
    }

    //! Finds the hour of the highest elevation between two hours by ternary
    //! search. The elevation must rise before this hour and fall after it.
    double find_highest(double first, double last) const {
        while (last - first > precision) {
            const double third = (last - first) / 3;
            if (at(first + third) < at(last - third))
                first += third;
            else
                last -= third;
        }
        return (first + last) / 2;
    }

    //! Finds the hour when the sun is at the horizon by bisection; returns
    //! nothing unless the sun is below the horizon at `low` and not below it at
    //! `high`.
    std::optional<double> find_crossing(double low, double high) const {
        if (at(low) >= 0 || at(high) < 0) return std::nullopt;
        while (std::abs(high - low) > precision) {
            const double middle = (low + high) / 2;
            (at(middle) < 0 ? low : high) = middle;
        }
        return high;
    }

  private:
    static constexpr double precision = 1e-4;  //!< precision of hours [h]

    const Site& site_;
    const Date& date_;
};

//! Largest difference between solar noon and mean noon [h]. The equation of
//! time is below 17 minutes; at high latitudes the change of declination adds a
//! little.
constexpr double largest_shift = 1;

}  // namespace

std::string to_string(const Date& date) {
    return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

std::optional<Date> to_date(const std::string& text) {
    Date date;
    char more = 0;
    if (std::sscanf(text.c_str(), "%4d-%2d-%2d%c", &date.year, &date.month,
                    &date.day, &more) != 3 ||
        !(std::chrono::year(date.year) / date.month / date.day).ok())
        return std::nullopt;
    return date;
}

double LightSeries::beam() const {
    return integrate_day(*this, &Irradiance::beam);
}

double LightSeries::diffuse() const {
    return integrate_day(*this, &Irradiance::diffuse);
}

double LightSeries::lit_seconds() const {
    double sum = 0;
    for (const TimeStep& step : steps)
        if (step.is_lit()) sum += step.seconds;
    return sum;
}

std::vector<double> LightSeries::hours() const {
    std::set<double> hours;
    for (const TimeStep& step : steps)
        if (step.sun.zenith < 90 || step.is_lit()) hours.insert(step.hour);
    return {hours.begin(), hours.end()};
}

std::vector<Date> LightSeries::dates() const {
    std::vector<Date> dates;
    for (const TimeStep& step : steps)
        if (dates.empty() || dates.back() != step.date)
            dates.push_back(step.date);
    return dates;
}

std::vector<std::vector<std::size_t>> LightSeries::steps_of_hours() const {
    const std::vector<double> sorted = hours();
    std::vector<std::vector<std::size_t>> result(sorted.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto hour =
            std::lower_bound(sorted.begin(), sorted.end(), steps[i].hour);
        if (hour != sorted.end() && *hour == steps[i].hour)
            result[static_cast<std::size_t>(hour - sorted.begin())].push_back(
                i);
    }
    return result;
}

std::vector<std::vector<std::size_t>> LightSeries::steps_of_dates() const {
    std::vector<std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (i == 0 || steps[i].date != steps[i - 1].date) result.emplace_back();
        result.back().push_back(i);
    }
    return result;
}

LightSeries clear_days(const Site& site, const DaySpan& span,
                       double par_fraction) {
    const int count = count_steps(span);
    const double step_hours = (span.end - span.start) / count;
    LightSeries series;
    series.days = static_cast<int>(span.dates.size());
    series.utc_offset = site.utc_offset;
    for (const Date& date : span.dates)
        for (int i = 0; i <= count; ++i) {
            const double hour =
                i == count ? span.end : span.start + i * step_hours;
            const SunPosition sun = sun_position(site, date, hour);
            if (sun.zenith >= 90) continue;
            const Irradiance solar = clear_sky(site, date, sun);
            const Irradiance par{par_fraction * solar.beam,
                                 par_fraction * solar.diffuse};
            const double weight = i == 0 || i == count ? 0.5 : 1.0;
            TimeStep& step = series.steps.emplace_back();
            step = {hour, weight * step_hours * 3600, sun, par, date};
            step.nir = {solar.beam - par.beam, solar.diffuse - par.diffuse};
        }
    return series;
}

Daylight daylight(const Site& site, const Date& date) {
    const Elevation elevation(site, date);
    const double mean_noon = 12 + clock_ahead(site);
    Daylight day;
    day.noon = elevation.find_highest(mean_noon - largest_shift,
                                      mean_noon + largest_shift);
    day.elevation = elevation.at(day.noon);
    day.sunrise = elevation.find_crossing(day.noon - 12, day.noon);
    day.sunset = elevation.find_crossing(day.noon + 12, day.noon);
    return day;
}

double clock_ahead(const Site& site) {
    return std::remainder(site.utc_offset - site.longitude / 15, 24);
}

double share_left_out(const Site& site, const DaySpan& span) {
    constexpr int instants = 24 * 60;
    const double midnight = clock_ahead(site);
    double total = 0, kept = 0;
    for (const Date& date : span.dates)
        for (int i = 0; i < instants; ++i) {
            const double hour = midnight + (i + 0.5) * 24 / instants;
            const Irradiance light =
                clear_sky(site, date, sun_position(site, date, hour));
            const double sum = light.beam + light.diffuse;
            total += sum;
            if (hour > span.start && hour < span.end) kept += sum;
        }
    return total > 0 ? 1 - kept / total : 0;
}

}  // namespace ideotype
