// SPDX-License-Identifier: Apache-2.0
// Any bytes are either weather without gaps or cause an InputError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "ideotype/climate/weather.hpp"

namespace {

void read(const std::string& text, const ideotype::WeatherRequest& request) {
    try {
        const auto weather = ideotype::parse_weather(text, request);
        if (weather.series.steps.empty()) std::abort();
        for (const auto& step : weather.series.steps)
            if (!(step.par.beam >= 0) || !(step.par.diffuse >= 0) ||
                !std::isfinite(step.temperature.value_or(0)) ||
                !(step.humidity.value_or(0) >= 0))
                std::abort();
    } catch (const ideotype::InputError&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
    const std::string text(data, data + size);
    ideotype::WeatherRequest request{"fuzz", {"here", 36.1, -79.95, -5, 273}};
    read(text, request);
    request.period = ideotype::Period{{1981, 7, 2}, {1981, 7, 3}};
    read(text, request);
    // These are the columns of nsrdb.csv.
    auto& columns = request.columns;
    columns.time = {"Year", "Month", "Day", "Hour", "Minute"};
    columns.stamp = ideotype::Stamp::middle;
    columns.global = ideotype::Column{"GHI", "W/m2"};
    columns.diffuse = ideotype::Column{"DHI", "W/m2"};
    read(text, request);
    return 0;
}
