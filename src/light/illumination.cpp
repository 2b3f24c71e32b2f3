#include "ideotype/light/illumination.hpp"

#include <utility>

namespace ideotype {

double Illumination::energy() const {
    double sum = 0;
    for (const Source& source : sources) sum += source.energy;
    return sum;
}

DayIllumination illuminate(Day day, SkyModel sky_model, double row_direction,
                           Skies skies) {
    DayIllumination result;
    std::vector<Source>& sources = result.light.sources;
    const auto add = [&](const Source& source) {
        if (!(source.energy > 0)) return -1;
        sources.push_back(source);
        return static_cast<int>(sources.size()) - 1;
    };
    const auto sun_of = [&](const TimeStep& step) {
        return SunPosition{step.sun.zenith, step.sun.azimuth - row_direction};
    };
    for (const TimeStep& step : day.steps)
        result.beam_of.push_back(add(
            {beam_direction(sun_of(step)), step.par.beam * step.seconds, {}}));
    if (sky_model == SkyModel::clear || skies == Skies::each) {
        for (const TimeStep& step : day.steps)
            result.sky_of.push_back(
                add({std::nullopt, step.par.diffuse * step.seconds,
                     SkySampler({sky_model, sun_of(step)})}));
    } else {
        const int sky =
            add({std::nullopt, day.diffuse(), SkySampler({sky_model, {}})});
        result.sky_of.assign(day.steps.size(), sky);
    }
    result.day = std::move(day);
    return result;
}

}  // namespace ideotype
