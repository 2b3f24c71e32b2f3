// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "campaign.hpp"
#include "ideotype/physiology/leaf.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {

namespace {

//! Returns the ratio of light to clear-sky light, or nothing if the sun is low.
std::optional<double> clearness_of(const TimeStep& step, const Site& site,
                                   double par_fraction) {
    if (step.sun.zenith > 75) return std::nullopt;
    const Irradiance clear = clear_sky(site, step.date, step.sun);
    const double most = par_fraction * (clear.beam + clear.diffuse);
    return std::clamp((step.par.beam + step.par.diffuse) / most, 0., 1.);
}

//! Fills in a value in all steps that lack it. Returns whether there were any.
template <class Estimate>
bool fill(LightSeries& series, std::optional<double> TimeStep::*member,
          const Estimate& estimate) {
    bool is_missing = false;
    for (TimeStep& step : series.steps) {
        if (step.*member) continue;
        step.*member = estimate(step);
        is_missing = true;
    }
    return is_missing;
}

}  // namespace

double standard_pressure(double elevation) {
    return 101.325 * std::pow(1 - 2.2558e-5 * elevation, 5.2559);
}

double sky_longwave(double temperature, double vapour, double clearness) {
    const double absolute = temperature + kelvin;
    const double clear = 1.24 * std::pow(vapour / absolute, 1 / 7.);
    return std::lerp(1, clear, clearness) * stefan_boltzmann *
           std::pow(absolute, 4);
}

void estimate_air(LightSeries& series, const Site& site, double par_fraction) {
    std::vector<std::string>& names = series.estimated;
    // Wind is known in all steps or in none.
    if (fill(series, &TimeStep::wind, [](const TimeStep&) { return 2.; })) {
        series.wind_height = 2;
        names.emplace_back("wind");
    }
    if (fill(series, &TimeStep::pressure, [&](const TimeStep&) {
            return standard_pressure(site.elevation);
        }))
        names.emplace_back("pressure");
    double clearness = 1;
    for (const TimeStep& step : series.steps)
        if (const auto first = clearness_of(step, site, par_fraction)) {
            clearness = *first;
            break;
        }
    if (fill(series, &TimeStep::longwave, [&](const TimeStep& step) {
            const Air air;
            const double t = step.temperature.value_or(air.temperature);
            clearness =
                clearness_of(step, site, par_fraction).value_or(clearness);
            return sky_longwave(
                t,
                10 * step.humidity.value_or(air.humidity) * saturated_vapour(t),
                clearness);
        }))
        names.emplace_back("longwave radiation");
}

}  // namespace ideotype
