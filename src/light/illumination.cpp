#include "ideotype/light/illumination.hpp"

namespace ideotype {

double Illumination::energy() const {
    double sum = 0;
    for (const Source& source : sources) sum += source.energy;
    return sum;
}

DayIllumination illuminate(const Day& day, double row_direction) {
    DayIllumination result;
    std::vector<Source>& sources = result.light.sources;
    const auto add = [&](const Source& source) {
        if (!(source.energy > 0)) return -1;
        sources.push_back(source);
        return static_cast<int>(sources.size()) - 1;
    };
    for (const TimeStep& step : day.steps) {
        SunPosition sun = step.sun;
        sun.azimuth -= row_direction;
        result.beam_of.push_back(
            add({beam_direction(sun), step.par.beam * step.seconds}));
    }
    result.sky = add({std::nullopt, day.diffuse()});
    return result;
}

}  // namespace ideotype
