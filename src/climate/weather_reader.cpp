// SPDX-License-Identifier: Apache-2.0
#include "ideotype/climate/weather_reader.hpp"

#include <algorithm>

#include "ideotype/core/file.hpp"
#include "weather_light.hpp"
#include "weather_place.hpp"

namespace ideotype {

WeatherReading parse_weather(const std::string& text,
                             const WeatherRequest& request) {
    const std::vector<std::string_view> lines = lines_of(text);
    const Layout layout = layout_of(lines, request);
    const RowTimes times = read_times(lines, layout, request);
    Doubts doubts(request.file);
    const std::vector<SeriesStep> series = complete_series(
        times, read_values(lines, layout, times, request), request, doubts);
    const std::vector<Irradiance> light = light_of(series, request, doubts);
    check_place(series, light, times.utc_offset, layout.station, request,
                doubts);

    Weather weather{request.file, times.utc_offset, {}};
    const auto seconds = static_cast<double>(times.step.count());
    for (std::size_t i = 0; i < series.size(); ++i) {
        const SeriesStep& step = series[i];
        std::optional<double> humidity = step.values.humidity;
        if (humidity) humidity = std::min(*humidity, 1.0);
        weather.series.steps.push_back(
            {hour_at(step.middle),
             seconds,
             step.sun,
             {request.par_fraction * light[i].beam,
              request.par_fraction * light[i].diffuse},
             date_at(step.middle),
             step.values.temperature,
             humidity});
    }
    weather.series.days = static_cast<int>(weather.series.dates().size());
    return {std::move(weather), doubts.warnings()};
}

WeatherReading read_weather(const WeatherRequest& request) {
    const FileText file = read_file(request.file, most_data_bytes);
    if (!file.is_there)
        throw InputError({{{request.file}, file.refusal(request.file)}});
    return parse_weather(file.text, request);
}

}  // namespace ideotype
