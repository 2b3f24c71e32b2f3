// SPDX-License-Identifier: Apache-2.0
#include "weather_series.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "weather_problems.hpp"

namespace ideotype {

namespace {

using namespace std::chrono;

bool is_leap_day(ClockTime time) {
    const Date date = date_at(time);
    return date.month == 2 && date.day == 29;
}

//! The steps, with the values of the rows that there are.
std::vector<SeriesStep> grid(const RowTimes& times,
                             const std::vector<WeatherValues>& values,
                             Problems& problems, Doubts& doubts) {
    const auto& rows = times.rows;
    // The first step of the period that is whole steps from the first row.
    ClockTime middle = rows.front().middle;
    middle -= (middle - times.begin) / times.step * times.step;
    const auto steps = (times.end - middle) / times.step;
    if (steps > 10 * static_cast<std::ptrdiff_t>(rows.size()) + 1000)
        problems.stop(rows.front().line, 1,
                      fmt::format("the file has {} of the {} time steps of the "
                                  "period",
                                  rows.size(), steps));
    std::vector<SeriesStep> series;
    std::size_t next = 0;
    int line = rows.front().line;
    for (; middle < times.end; middle += times.step) {
        while (next < rows.size() && rows[next].middle < middle) {
            problems.add(rows[next].line, 1,
                         fmt::format("the time is not whole steps of {} s "
                                     "after those before it",
                                     times.step.count()));
            ++next;
        }
        SeriesStep step{line, middle, {}, {}, 0};
        if (next < rows.size() && rows[next].middle == middle) {
            step.line = line = rows[next].line;
            step.values = values[next++];
        } else if (is_leap_day(middle)) {
            const ClockTime day = floor<days>(middle);
            const bool whole =
                std::none_of(rows.begin(), rows.end(), [&](const RowTime& row) {
                    return floor<days>(row.middle) == day;
                });
            if (whole) {
                if (middle - day < times.step)
                    doubts.note(line, "29 February is not in the file");
                continue;
            }
        }
        series.push_back(step);
    }
    problems.stop_if_any();
    return series;
}

//! Fills what is not known between two values that are.
void interpolate(std::vector<SeriesStep>& series,
                 std::optional<double> WeatherValues::*member,
                 const std::string& name, seconds step, Problems& problems,
                 Doubts& doubts) {
    const auto known = [&](const SeriesStep& each) {
        return (each.values.*member).has_value();
    };
    if (std::none_of(series.begin(), series.end(), known)) return;
    for (auto begin = series.begin(); begin != series.end();) {
        begin = std::find_if_not(begin, series.end(), known);
        const auto end = std::find_if(begin, series.end(), known);
        if (begin == end) break;
        if ((end - begin) * step > 6h)
            problems.add(
                begin->line, 1,
                fmt::format(
                    "the {} is not known for {} hours", name,
                    duration_cast<hours>((end - begin) * step).count()));
        const auto count = static_cast<double>(end - begin + 1);
        const auto before = begin == series.begin() ? end : begin - 1;
        const auto after = end == series.end() ? before : end;
        const double first = *(before->values.*member);
        const double last = *(after->values.*member);
        for (auto each = begin; each != end; ++each) {
            const auto part = static_cast<double>(each - begin + 1) / count;
            each->values.*member = first + part * (last - first);
            doubts.count(
                each->line,
                fmt::format(
                    "a value of the {} is not known and is interpolated",
                    name));
        }
        begin = end;
    }
}

}  // namespace

std::vector<SeriesStep> complete_series(
    const RowTimes& times, const std::vector<WeatherValues>& values,
    const WeatherRequest& request, Doubts& doubts) {
    Problems problems(request.file);
    std::vector<SeriesStep> series = grid(times, values, problems, doubts);
    interpolate(series, &WeatherValues::temperature, "temperature", times.step,
                problems, doubts);
    interpolate(series, &WeatherValues::humidity, "humidity", times.step,
                problems, doubts);
    problems.stop_if_any();

    Site site = request.site;
    site.utc_offset = times.utc_offset;
    const auto sun_at = [&](ClockTime time) {
        return sun_position(site, date_at(time), hour_at(time));
    };
    for (SeriesStep& step : series) {
        step.sun = sun_at(step.middle);
        step.highest =
            90 - std::min({step.sun.zenith,
                           sun_at(step.middle - times.step / 2).zenith,
                           sun_at(step.middle + times.step / 2).zenith});
    }
    return series;
}

}  // namespace ideotype
