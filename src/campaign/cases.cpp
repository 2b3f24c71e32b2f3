// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "campaign.hpp"
#include "ideotype/core/hash.hpp"
#include "problems.hpp"

namespace ideotype {

namespace {

void add_scenario(const Campaign& campaign, const Case& scenario,
                  std::vector<Case>& all) {
    Case one = scenario;
    if (is_over(campaign, "site")) one.site.name = "all";
    if (is_over(campaign, "day") || is_over(campaign, "climate"))
        one.day_name = "all";
    if (is_over(campaign, "spacing")) one.spacing_name = "all";
    const auto names = [](const Case& x) {
        return std::tie(x.site.name, x.day_name, x.spacing_name);
    };
    one.stages.clear();
    auto found = std::ranges::find_if(
        all, [&](const Case& other) { return names(other) == names(one); });
    if (found == all.end()) found = all.insert(all.end(), std::move(one));
    found->scenarios.push_back(scenario);
}

//! Returns the series of a site's weather: dates are those of the file, hours
//! are in the time of the site.
LightSeries to_series(const SiteWeather& weather, const Site& here) {
    Site site = here;
    site.utc_offset = weather.utc_offset;
    const auto at = [](const std::vector<double>& values, std::size_t i) {
        return values.empty() ? std::nullopt : std::optional(values.at(i));
    };
    const double seconds = 86400 / static_cast<double>(weather.hours.size());
    LightSeries series;
    series.days = static_cast<int>(weather.dates.size());
    series.utc_offset = here.utc_offset;
    const double shift = here.utc_offset - weather.utc_offset;
    for (const Date& date : weather.dates)
        for (const double hour : weather.hours) {
            const std::size_t i = series.steps.size();
            series.steps.push_back({hour + shift,
                                    seconds,
                                    sun_position(site, date, hour),
                                    {},
                                    date,
                                    at(weather.temperature, i),
                                    at(weather.humidity, i),
                                    {},
                                    at(weather.wind, i),
                                    at(weather.pressure, i),
                                    at(weather.longwave, i)});
            for (std::size_t b = 0; b < wavebands.size(); ++b)
                series.steps.back().*wavebands[b].light = {
                    at(weather.beam[b], i).value_or(0),
                    at(weather.diffuse[b], i).value_or(0)};
        }
    return series;
}

//! Names a case by its axes, its trait set and its replicate. The name does not
//! depend on the number of other cases: axes with one entry are named too.
void complete(Case& one, const Named<TraitSet>& traits, int replicate) {
    one.traits = traits.value;
    one.trait_set_name = traits.name;
    one.replicate = replicate;
    one.name =
        lower_case(fmt::format("{}_{}_{}_{}_r{}", one.site.name, one.day_name,
                               one.spacing_name, traits.name, replicate));
}

//! Returns all cases without traits, seed and replicate.
std::vector<Case> stands(const Campaign& campaign) {
    std::vector<Named<DaySpan>> days = campaign.days;
    for (const auto& climate : campaign.climates)
        days.push_back({climate.name, {}});
    std::vector<Case> all;
    for (const Site& site : campaign.sites)
        for (const auto& day : days)
            for (const auto& spacing : campaign.spacings) {
                Case one;
                one.site = site;
                one.day = day.value;
                one.spacing = spacing.value;
                one.day_name = day.name;
                one.spacing_name = spacing.name;
                add_stages(campaign, one);
                if (campaign.over.empty())
                    all.push_back(std::move(one));
                else
                    add_scenario(campaign, one, all);
            }
    return all;
}

}  // namespace

bool is_over(const Campaign& campaign, const std::string& axis) {
    return std::ranges::find(campaign.over, axis) != campaign.over.end();
}

std::vector<Case> scenarios(const Case& chosen) {
    return chosen.scenarios.empty() ? std::vector{chosen} : chosen.scenarios;
}

std::vector<Case> evaluated_cases(const Case& chosen) {
    std::vector<Case> all;
    for (const Case& each : scenarios(chosen))
        if (each.stages.empty())
            all.push_back(each);
        else
            all.insert(all.end(), each.stages.begin(), each.stages.end());
    return all;
}

std::vector<Case> cases(const Campaign& campaign) {
    std::vector<Case> all;
    for (const Case& stand : stands(campaign))
        for (const auto& traits : campaign.trait_sets)
            for (int r = 1; r <= campaign.replicates; ++r) {
                Case one = stand;
                one.index = static_cast<int>(all.size());
                complete(one, traits, r);
                one.seed = derive_seed(campaign.seed, one.name);
                const auto pass_on = [&](std::vector<Case>& parts) {
                    for (Case& part : parts) {
                        part.index = one.index;
                        complete(part, traits, r);
                        part.seed = one.seed;
                    }
                };
                pass_on(one.scenarios);
                pass_on(one.stages);
                for (Case& scenario : one.scenarios) pass_on(scenario.stages);
                all.push_back(std::move(one));
            }
    return all;
}

LightSeries light_of(const Campaign& campaign, const Case& chosen) {
    if (!chosen.scenarios.empty())
        return light_of(campaign, chosen.scenarios.front());
    if (campaign.climates.empty()) {
        LightSeries series =
            clear_days(chosen.site, chosen.day, campaign.par_fraction);
        if (campaign.water)
            estimate_air(series, chosen.site, campaign.par_fraction);
        return series;
    }
    for (const SiteWeather& weather : campaign.weathers)
        if (weather.site == chosen.site.name &&
            weather.climate == chosen.day_name) {
            LightSeries series = to_series(weather, chosen.site);
            for (const auto& [name, climate] : campaign.climates)
                if (name == chosen.day_name) {
                    series.wind_height =
                        climate.wind_height.value_or(series.wind_height);
                    series.co2 = climate.co2.value_or(series.co2);
                }
            if (campaign.water)
                estimate_air(series, chosen.site, campaign.par_fraction);
            return chosen.stage ? at_stage(campaign, chosen, std::move(series))
                                : series;
        }
    throw Error("the campaign has no weather for case " + chosen.name);
}

Case case_at(const Campaign& campaign, int index, const std::string& path) {
    const std::vector<Case> all = cases(campaign);
    if (index < 0 || index >= static_cast<int>(all.size()))
        throw wrong_usage(
            "there is no case {}; {} has cases 0 to {} (see ideotype check "
            "--cases)",
            index, path, all.size() - 1);
    return all[static_cast<std::size_t>(index)];
}

std::vector<int> bred_rows(const Campaign& campaign) {
    std::vector<bool> is_taken(static_cast<std::size_t>(campaign.field.rows));
    for (const ComponentEntry& each : campaign.components)
        for (const int row : each.standing.rows)
            is_taken[static_cast<std::size_t>(row)] = true;
    std::vector<int> rows;
    for (std::size_t row = 0; row < is_taken.size(); ++row)
        if (!is_taken[row]) rows.push_back(static_cast<int>(row));
    return rows;
}

std::size_t bred_plants(const Campaign& campaign) {
    std::size_t count = bred_rows(campaign).size() *
                        static_cast<std::size_t>(campaign.field.plants);
    for (const ComponentEntry& each : campaign.components)
        count -= static_cast<std::size_t>(each.standing.mixed);
    return count;
}

}  // namespace ideotype
