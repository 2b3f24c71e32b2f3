#include "ideotype/climate/day.hpp"

#include <cmath>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

double sum_over(const Day& day, double Irradiance::*component) {
    double sum = 0;
    for (const TimeStep& step : day.steps)
        sum += step.par.*component * step.seconds;
    return sum;
}

//! How many steps the span has.
int step_count(const DaySpan& span) {
    const double steps = (span.end - span.start) * 60 / span.step_minutes;
    const double whole = std::round(steps);
    if (!(whole >= 1) || !(std::abs(steps - whole) <= 1e-6))
        throw Error(
            "the time steps of a day do not fit between its start and end "
            "(the step must divide the time between them)");
    return static_cast<int>(whole);
}

}  // namespace

double Day::beam() const {
    return sum_over(*this, &Irradiance::beam);
}

double Day::diffuse() const {
    return sum_over(*this, &Irradiance::diffuse);
}

double Day::incident() const {
    return beam() + diffuse();
}

Day clear_day(const Site& site, const DaySpan& span, double par_fraction) {
    const int count = step_count(span);
    const double step_hours = (span.end - span.start) / count;
    Day day;
    for (int i = 0; i <= count; ++i) {
        const double hour = i == count ? span.end : span.start + i * step_hours;
        const SunPosition sun = sun_position(site, span.date, hour);
        if (sun.zenith >= 90) continue;
        const Irradiance solar = clear_sky(site, span.date, sun);
        const double weight = i == 0 || i == count ? 0.5 : 1.0;
        day.steps.push_back(
            {hour,
             weight * step_hours * 3600,
             sun,
             {par_fraction * solar.beam, par_fraction * solar.diffuse}});
    }
    return day;
}

}  // namespace ideotype
