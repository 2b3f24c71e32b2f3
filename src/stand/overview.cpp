// SPDX-License-Identifier: Apache-2.0
#include "overview.hpp"

#include <set>
#include <utility>

#include "ideotype/climate/light_series.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! Returns the mean of a variable weighted by light; nothing if any step lacks
//! it.
std::optional<double> mean_in_light(const LightSeries& series,
                                    std::optional<double> TimeStep::*value) {
    double sum = 0, light = 0;
    for (const TimeStep& step : series.steps) {
        if (!(step.*value)) return std::nullopt;
        const double par = step.par.beam + step.par.diffuse;
        sum += par * *(step.*value);
        light += par;
    }
    return sum / light;
}

std::optional<AirOverview> air_of(const Campaign& campaign, const Site& site,
                                  LightSeries series) {
    const TimeStep& first = series.steps.front();
    if (!first.wind && !first.pressure && !first.longwave &&
        series.co2 == LightSeries{}.co2)
        return std::nullopt;
    estimate_air(series, site, campaign.spec.par_fraction);
    const auto mean = [&](std::optional<double> TimeStep::*value) {
        double sum = 0;
        for (const TimeStep& step : series.steps) sum += *(step.*value);
        return sum / static_cast<double>(series.steps.size());
    };
    return AirOverview{mean(&TimeStep::wind),
                       series.wind_height,
                       mean(&TimeStep::pressure),
                       mean(&TimeStep::longwave),
                       series.co2,
                       series.estimated};
}

SkyOverview sky_of(const Campaign& campaign, const Case& chosen) {
    const bool is_climate = !campaign.spec.climates.empty();
    const Site& site = chosen.site;
    const LightSeries series = light_of(campaign, chosen);
    const std::vector<Date> dates =
        is_climate ? series.dates() : chosen.day.dates;
    SkyOverview sky{site,
                    chosen.day_name,
                    dates.size(),
                    daylight(site, dates[dates.size() / 2]),
                    series.steps.size(),
                    series.incident(),
                    series.diffuse() / series.incident()};
    if (!is_climate) {
        sky.left_out = share_left_out(site, chosen.day);
        return sky;
    }
    sky.temperature = mean_in_light(series, &TimeStep::temperature);
    sky.humidity = mean_in_light(series, &TimeStep::humidity);
    sky.air = air_of(campaign, site, series);
    return sky;
}

}  // namespace

StandsOverview overview_of(const Campaign& campaign, double leaf_area) {
    StandsOverview overview;
    for (const auto& [name, spacing] : campaign.spec.spacings) {
        overview.period_x.add(campaign.spec.field.rows * spacing.row);
        overview.period_y.add(campaign.spec.field.plants * spacing.plant);
        overview.lai.add(leaf_area / (spacing.row * spacing.plant));
    }
    // Many cases share their site and day.
    std::set<std::pair<std::string, std::string>> of_cases, seen;
    const Cases some = cases(campaign);
    for (std::size_t i = 0; i < some.size(); ++i) {
        const CaseName name = some.name(i);
        if (!of_cases.emplace(name.site_name, name.day_name).second) continue;
        for (const Case& each : scenarios(some[i]))
            if (seen.emplace(each.site.name, each.day_name).second)
                overview.skies.push_back(sky_of(campaign, each));
    }
    return overview;
}

std::vector<StageOverview> stages_overview(const Campaign& campaign,
                                           const Case& chosen) {
    std::vector<StageOverview> stages;
    for (const Case& scenario : scenarios(chosen))
        for (const Case& at : scenario.stages) {
            StageOverview& stage = stages.emplace_back();
            stage.climate = scenario.day_name;
            stage.emergence = climate_of(campaign, scenario).emergence;
            stage.stage = *at.stage;
            for (const Component& one : scene_of(campaign, at).components) {
                stage.green += lai_of_line(one.mesh, one.ground_per_plant);
                stage.dead += dead_area(one.mesh) / one.ground_per_plant;
            }
        }
    return stages;
}

}  // namespace ideotype
