// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/illumination.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

bool is_up(const TimeStep& step) {
    return step.sun.zenith < 90;
}

//! Returns the middle dates of equal parts of a series, or all dates if there
//! are no more than `count`.
std::vector<Date> dates_of_suns(const LightSeries& series, int count) {
    const std::vector<Date> all = series.dates();
    const auto n = static_cast<std::size_t>(count);
    if (n == 0 || all.size() <= n) return all;
    std::vector<Date> dates;
    for (std::size_t i = 0; i < n; ++i)
        dates.push_back(all[(2 * i + 1) * all.size() / (2 * n)]);
    return dates;
}

//! Returns, for each instant, the instant that provides its sun position.
std::vector<std::size_t> instants_of_suns(const LightSeries& series,
                                          int count) {
    const std::vector<Date> dates = dates_of_suns(series, count);
    std::vector<std::size_t> suns;
    for (std::size_t i = 0; i < series.steps.size(); ++i)
        if (is_up(series.steps[i]) &&
            std::find(dates.begin(), dates.end(), series.steps[i].date) !=
                dates.end())
            suns.push_back(i);
    const auto direction = [&](std::size_t i) {
        return beam_direction(series.steps[i].sun);
    };
    const std::vector<glm::dvec3> directions = mapped(suns, direction);
    std::vector<std::size_t> chosen(series.steps.size());
    std::size_t own = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        chosen[i] = i;
        while (own < suns.size() && suns[own] < i) ++own;
        if (suns.empty() || (own < suns.size() && suns[own] == i)) continue;
        const glm::dvec3 here = direction(i);
        const auto nearest =
            std::max_element(directions.begin(), directions.end(),
                             [&](const glm::dvec3& a, const glm::dvec3& b) {
                                 return glm::dot(a, here) < glm::dot(b, here);
                             });
        chosen[i] =
            suns[static_cast<std::size_t>(nearest - directions.begin())];
    }
    return chosen;
}

}  // namespace

double Illumination::energy() const {
    double sum = 0;
    for (const Source& source : sources) sum += source.energy;
    return sum;
}

SeriesIllumination illuminate(LightSeries series, SkyModel sky_model,
                              double row_direction, Skies skies, int dates) {
    IDEOTYPE_EXPECT(series.days > 0 && dates >= 0);
    IDEOTYPE_EXPECT(std::isfinite(row_direction));
    SeriesIllumination result;
    const std::vector<TimeStep>& steps = series.steps;
    const std::vector<std::size_t> sun_of = instants_of_suns(series, dates);
    const auto sun = [&](std::size_t i) {
        const SunPosition& position = steps[i].sun;
        return SunPosition{position.zenith, position.azimuth - row_direction};
    };
    // Adds one light source per sun position with light of this part; returns
    // the index of the source of each instant.
    const auto add = [&](double Irradiance::*part, const auto& source_of) {
        std::vector<double> energy(steps.size());
        for (std::size_t i = 0; i < steps.size(); ++i)
            energy[sun_of[i]] +=
                steps[i].par.*part * steps[i].seconds / series.days;
        std::vector<int> source(steps.size(), -1);
        std::vector<Source>& sources = result.light.sources;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (!(energy[i] > 0)) continue;
            source[i] = static_cast<int>(sources.size());
            sources.push_back(source_of(i));
            sources.back().energy = energy[i];
            result.instant_of.push_back(i);
        }
        std::vector<int> found;
        for (std::size_t i = 0; i < steps.size(); ++i)
            found.push_back(steps[i].par.*part > 0 ? source[sun_of[i]] : -1);
        return found;
    };
    result.beam_of = add(&Irradiance::beam, [&](std::size_t i) {
        return Source{beam_direction(sun(i)), 0, {}};
    });
    if (sky_model == SkyModel::clear || skies == Skies::each) {
        result.sky_of = add(&Irradiance::diffuse, [&](std::size_t i) {
            // A clear sky requires a sun above the horizon.
            return Source{
                std::nullopt, 0,
                SkySampler(is_up(steps[i]) ? SkyRadiance{sky_model, sun(i)}
                                           : SkyRadiance{})};
        });
    } else {
        const int sky = static_cast<int>(result.light.sources.size());
        for (const TimeStep& step : steps)
            result.sky_of.push_back(step.par.diffuse > 0 ? sky : -1);
        if (series.diffuse() > 0) {
            result.light.sources.push_back(
                {std::nullopt, series.diffuse(), SkySampler({sky_model, {}})});
            result.instant_of.push_back(0);
        }
    }
    IDEOTYPE_ENSURE(result.beam_of.size() == steps.size());
    IDEOTYPE_ENSURE(result.sky_of.size() == steps.size());
    for (const Source& source : result.light.sources)
        IDEOTYPE_ENSURE(source.energy > 0);
    result.series = std::move(series);
    return result;
}

SeriesIllumination in_band(SeriesIllumination light,
                           Irradiance TimeStep::*band) {
    IDEOTYPE_EXPECT(light.beam_of.size() == light.series.steps.size());
    IDEOTYPE_EXPECT(light.sky_of.size() == light.series.steps.size());
    for (Source& source : light.light.sources) source.energy = 0;
    for (std::size_t i = 0; i < light.series.steps.size(); ++i) {
        TimeStep& step = light.series.steps[i];
        step.par = step.*band;
        const auto add = [&](int source, double& irradiance) {
            if (source < 0)
                irradiance = 0;
            else
                light.light.sources[static_cast<std::size_t>(source)].energy +=
                    irradiance * step.seconds / light.series.days;
        };
        add(light.beam_of[i], step.par.beam);
        add(light.sky_of[i], step.par.diffuse);
    }
    return light;
}

}  // namespace ideotype
