// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/clock.hpp"
#include "ideotype/core/units.hpp"
#include "weather_table.hpp"

namespace ideotype {

namespace {

//! The usual difference between instruments [W m-2]. Larger differences cause a
//! warning.
constexpr double noticeable = 20;

//! Sets slightly negative values to 0, and counts them.
WeatherValues remove_negative(WeatherValues values, int line,
                              Findings& findings) {
    for (const auto member :
         {&WeatherValues::global, &WeatherValues::beam_normal,
          &WeatherValues::diffuse}) {
        std::optional<double>& value = values.*member;
        if (!value || *value >= 0) continue;
        value = 0;
        findings.doubt(line,
                       "a value of light is slightly negative; it counts as 0");
    }
    return values;
}

//! Returns the diffuse part of global light, from the best information that the
//! row contains.
double compute_diffuse(const WeatherValues& values, double extraterrestrial,
                       const WeatherStep& step, Findings& findings) {
    const double global = *values.global;
    if (values.diffuse) {
        if (*values.diffuse > 1.05 * global + noticeable)
            findings.doubt(step.line,
                           "a step has more diffuse than global light, all of "
                           "which counts as diffuse");
        return std::min(*values.diffuse, global);
    }
    if (values.diffuse_fraction)
        return std::min(*values.diffuse_fraction, 1.0) * global;
    if (values.beam_normal)
        return std::max(
            global - *values.beam_normal * std::cos(step.sun.zenith * degree),
            0.0);
    return diffuse_fraction(global, extraterrestrial, step.sun.zenith) * global;
}

//! Splits the light of a step into beam and diffuse light.
Irradiance split(const WeatherStep& step, Findings& findings) {
    const WeatherValues values =
        remove_negative(step.values, step.line, findings);
    if (step.sun.zenith >= 90)
        return {0, values.global ? *values.global : *values.diffuse};
    const double extraterrestrial =
        extraterrestrial_normal(date_at(step.middle));
    const double cosine = std::cos(step.sun.zenith * degree);
    const double largest_beam = extraterrestrial * cosine;
    Irradiance light;
    if (values.global) {
        light.diffuse =
            compute_diffuse(values, extraterrestrial, step, findings);
        light.beam = *values.global - light.diffuse;
    } else {
        light = {*values.beam_normal * cosine, *values.diffuse};
    }
    if (light.beam > largest_beam) {
        if (light.beam > largest_beam + noticeable)
            findings.doubt(step.line,
                           "a step has more beam than there is outside the "
                           "atmosphere; it is capped");
        if (values.global) light.diffuse += light.beam - largest_beam;
        light.beam = largest_beam;
    }
    return light;
}

}  // namespace

std::vector<Irradiance> split_light(const std::vector<WeatherStep>& series,
                                    Findings& findings) {
    std::vector<Irradiance> light;
    double global = 0, apart = 0;
    const WeatherStep* missing = nullptr;
    for (const WeatherStep& step : series) {
        const bool was_missing = missing != nullptr;
        missing = nullptr;
        light.emplace_back();
        const WeatherValues& values = step.values;
        if (values.lit()) {
            light.back() = split(step, findings);
            if (values.global && values.beam_normal && values.diffuse &&
                step.sun.zenith < 85) {
                global += *values.global;
                apart +=
                    *values.beam_normal * std::cos(step.sun.zenith * degree) +
                    *values.diffuse - *values.global;
            }
        } else if (step.highest <= 0) {
            findings.doubt(
                step.line,
                "a step of the night has no light in the file; it counts as 0");
        } else {
            missing = &step;
            // Report only the first of consecutive missing steps.
            if (!was_missing)
                findings.add_row(
                    0, step.line, 1,
                    "the light of {} {} is not known (a gap or a missing value "
                    "by day); fill it, or choose another period",
                    to_string(date_at(step.middle)),
                    clock_time(hour_at(step.middle)));
        }
    }
    findings.stop_if_any();
    if (std::abs(apart) > 0.1 * global)
        findings.doubt(
            series.front().line,
            fmt::format("beam and diffuse light sum to {:.0f} % of the global "
                        "light; diffuse and global light count",
                        100 * (1 + apart / global)));
    return light;
}

}  // namespace ideotype
