// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/units.hpp"
#include "weather_table.hpp"

namespace ideotype {

namespace {

using namespace std::chrono;

//! Makes all time steps of the period, with values where the file contains a
//! row. If 29 February has no rows, it is omitted.
std::vector<WeatherStep> make_steps(const WeatherTable& table,
                                    Findings& findings) {
    const auto& rows = table.rows;
    // Find the first step of the period: it precedes the first row by a whole
    // number of steps.
    ClockTime middle = rows.front().middle;
    middle -= (middle - table.begin) / table.step * table.step;
    const auto steps = (table.end - middle) / table.step;
    if (steps > 10 * static_cast<std::ptrdiff_t>(rows.size()) + 1000)
        findings.stop(rows.front().line, 1,
                      "the file has only {} of the {} time steps of the "
                      "period; check its dates",
                      rows.size(), steps);
    std::vector<WeatherStep> series;
    std::size_t next = 0;
    int line = rows.front().line;
    for (; middle < table.end; middle += table.step) {
        while (next < rows.size() && rows[next].middle < middle)
            findings.add_row(
                0, rows[next++].line, 1,
                "the time is not a whole number of steps of {} s after the row "
                "before; correct it, or leave the row out",
                table.step.count());
        if (next < rows.size() && rows[next].middle == middle) {
            series.push_back(rows[next++]);
            line = series.back().line;
            continue;
        }
        const ClockTime day = floor<days>(middle);
        const Date date = date_at(day);
        if (date.month == 2 && date.day == 29 &&
            std::none_of(rows.begin(), rows.end(), [&](const WeatherStep& row) {
                return floor<days>(row.middle) == day;
            })) {
            if (middle - day < table.step)
                findings.doubt(line, "29 February is not in the file", false);
            continue;
        }
        series.push_back({line, middle});
    }
    findings.stop_if_any();
    return series;
}

//! Interpolates gaps in a variable linearly over up to 6 hours.
void interpolate(std::vector<WeatherStep>& series,
                 std::optional<double> WeatherValues::*member,
                 const std::string& name, seconds step, Findings& findings) {
    const auto known = [&](const WeatherStep& row) {
        return (row.values.*member).has_value();
    };
    if (std::none_of(series.begin(), series.end(), known)) return;
    // Each pass fills one gap, from `begin` to `end`.
    for (auto begin = series.begin(); begin != series.end();) {
        begin = std::find_if_not(begin, series.end(), known);
        const auto end = std::find_if(begin, series.end(), known);
        if (begin == end) break;
        if ((end - begin) * step > 6h)
            findings.add(
                begin->line, 1,
                "the {} is not known for {} hours (gaps of up to 6 hours are "
                "filled); fill the gap, or choose another period",
                name, duration_cast<hours>((end - begin) * step).count());
        const auto count = static_cast<double>(end - begin + 1);
        const auto before = begin == series.begin() ? end : begin - 1;
        const auto after = end == series.end() ? before : end;
        const double first = *(before->values.*member);
        const double last = *(after->values.*member);
        for (auto gap = begin; gap != end; ++gap) {
            const auto fraction = static_cast<double>(gap - begin + 1) / count;
            gap->values.*member = first + fraction * (last - first);
            findings.doubt(gap->line, "a value of the " + name +
                                          " is not known and is interpolated");
        }
        begin = end;
    }
}

//! Sets the position of the sun in the middle of a step, and the highest
//! elevation of the sun during the step.
void place_sun(WeatherStep& step, const Site& site, seconds length) {
    const auto position_at = [&](ClockTime time) {
        return sun_position(site, date_at(time), hour_at(time));
    };
    step.sun = position_at(step.middle);
    step.highest =
        90 -
        std::min({step.sun.zenith, position_at(step.middle - length / 2).zenith,
                  position_at(step.middle + length / 2).zenith});
}

//! Computes the solar radiation outside PAR from the share of PAR. Its diffuse
//! fraction is that of PAR.
Irradiance complement_par(const Irradiance& par, double share) {
    const double ratio = 1 / share - 1;
    return {ratio * par.beam, ratio * par.diffuse};
}

//! Warns if the number of photons and the global light are inconsistent.
void compare_photons(const std::vector<WeatherStep>& steps, double par_fraction,
                     Findings& findings) {
    // Photons of PAR per energy of sunlight over a whole season [umol J-1].
    constexpr double expected = 2.06, tolerated = 0.05;
    double photons = 0, energy = 0;
    for (const WeatherStep& step : steps)
        if (step.values.ppfd && step.values.global) {
            photons += *step.values.ppfd * par_fraction * mol_per_mj_par;
            energy += *step.values.global;
        }
    const double ratio = energy > 0 ? photons / energy : expected;
    if (std::abs(ratio / expected - 1) > tolerated)
        findings.doubt(
            steps.front().line,
            fmt::format("there are {:.2f} umol of photons per J of global "
                        "light instead of {}; one of the two sensors may "
                        "have drifted",
                        ratio, expected),
            false);
}

}  // namespace

//! The text of a file, to which lines and header refer.
struct WeatherFile::Contents {
    Contents(std::string file_text, const WeatherRequest& file_request)
        : text(std::move(file_text)), request(file_request) {
        Findings findings(request.file);
        table = read_table(lines, request, findings);
    }

    std::string text;
    WeatherRequest request;
    std::vector<std::string_view> lines = split_lines(text);
    WeatherTable table;
};

WeatherFile::WeatherFile(std::string text, const WeatherRequest& request)
    : contents_(std::make_shared<Contents>(std::move(text), request)) {}

Weather parse_weather(const std::string& text, const WeatherRequest& request) {
    return WeatherFile(text, request).parse(request.period);
}

Weather WeatherFile::parse(const std::optional<Period>& period) const {
    const auto& [text, request, lines, whole] = *contents_;
    Findings findings(request.file);
    WeatherTable table = select_period(whole, period, findings);
    read_values(table, lines, request.par_fraction, findings);
    // Read all values, and interpolate those of the air.
    std::vector<WeatherStep> steps = make_steps(table, findings);
    using Values = WeatherValues;
    for (const auto& [member, name] :
         {std::pair{&Values::temperature, "temperature"},
          std::pair{&Values::humidity, "humidity"},
          std::pair{&Values::wind, "wind"},
          std::pair{&Values::pressure, "pressure"},
          std::pair{&Values::longwave, "longwave radiation"}})
        interpolate(steps, member, name, table.step, findings);
    findings.stop_if_any();
    // Split the light by the position of the sun, and check it.
    Site site = request.site;
    site.utc_offset = table.utc_offset;
    for (WeatherStep& step : steps) place_sun(step, site, table.step);
    const std::vector<Irradiance> light = split_light(steps, findings);
    check_place(table, steps, light, site, findings);
    compare_photons(steps, request.par_fraction, findings);

    // Convert each step to PAR and near infrared.
    LightSeries series;
    series.utc_offset = table.utc_offset;
    const bool has_rain = table.columns.rain.has_value();
    const auto seconds = static_cast<double>(table.step.count());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const WeatherStep& step = steps[i];
        std::optional<double> humidity = step.values.humidity;
        if (humidity) humidity = std::min(*humidity, 1.0);
        const Date date = date_at(step.middle);
        const Irradiance par{request.par_fraction * light[i].beam,
                             request.par_fraction * light[i].diffuse};
        const double share =
            table.counts_photons
                ? par_share(par.beam + par.diffuse,
                            extraterrestrial_normal(date), step.sun.zenith)
                : request.par_fraction;
        series.steps.push_back(
            {hour_at(step.middle), seconds, step.sun, par, date,
             step.values.temperature, humidity, complement_par(par, share),
             step.values.wind, step.values.pressure, step.values.longwave,
             has_rain ? std::optional(step.values.rain.value_or(0))
                      : std::nullopt});
    }
    series.days = static_cast<int>(series.dates().size());
    return {std::move(series), findings.warnings()};
}

}  // namespace ideotype
