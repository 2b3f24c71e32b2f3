// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "campaign.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/hash.hpp"
#include "spec/problems.hpp"

namespace ideotype {

namespace {

//! The number of entries on each axis that distinguish cases. An axis with
//! scenarios counts as one entry.
struct Axes {
    explicit Axes(const Spec& spec)
        : sites(is_over(spec, "site") ? 1 : spec.sites.size()),
          days(is_over(spec, "day") || is_over(spec, "climate")
                   ? 1
                   : spec.days.size() + spec.climates.size()),
          spacings(is_over(spec, "spacing") ? 1 : spec.spacings.size()),
          trait_sets(spec.trait_sets.size()),
          replicates(static_cast<std::size_t>(spec.replicates)) {}

    std::size_t size() const {
        return sites * days * spacings * trait_sets * replicates;
    }

    std::size_t sites, days, spacings, trait_sets, replicates;
};

//! The entry of a case or scenario on each axis.
struct AxisEntries {
    std::size_t site, day, spacing, traits, replicate, draw;
};

AxisEntries entries_of(const Axes& axes, std::size_t index) {
    const auto next = [&](std::size_t entries) {
        const std::size_t entry = index % entries;
        index /= entries;
        return entry;
    };
    AxisEntries entry{};
    entry.replicate = next(axes.replicates);
    entry.traits = next(axes.trait_sets);
    entry.spacing = next(axes.spacings);
    entry.day = next(axes.days);
    entry.site = index;
    return entry;
}

//! Converts the weather at a site to a light series. Dates are those of the
//! file; hours are in the local time of the site.
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
                                    at(weather.longwave, i),
                                    at(weather.rain, i)});
            for (std::size_t b = 0; b < wavebands.size(); ++b)
                series.steps.back().*wavebands[b].light = {
                    at(weather.beam[b], i).value_or(0),
                    at(weather.diffuse[b], i).value_or(0)};
        }
    return series;
}

std::string name_of_day(const Spec& spec, std::size_t day) {
    const std::size_t days = spec.days.size();
    return day < days ? spec.days[day].name : spec.climates.at(day - days).name;
}

//! Composes the name of a scenario from its axis entries, trait set and
//! replicate. Axes with one entry are included, so that the name does not
//! depend on the number of cases.
void set_name(CaseName& one) {
    one.name = lower_case(fmt::format("{}_{}_{}_{}_r{}", one.site_name,
                                      one.day_name, one.spacing_name,
                                      one.trait_set_name, one.replicate));
}

CaseName name_of_scenario(const Spec& spec, const AxisEntries& entry) {
    CaseName one;
    one.site_name = spec.sites.at(entry.site).name;
    one.day_name = name_of_day(spec, entry.day);
    one.spacing_name = spec.spacings.at(entry.spacing).name;
    one.trait_set_name = spec.trait_sets.at(entry.traits).name;
    one.replicate = static_cast<int>(entry.replicate) + 1;
    set_name(one);
    return one;
}

//! Makes a scenario that uses the index and the seed of its case.
Case scenario_of(const Campaign& campaign, const AxisEntries& entry,
                 const CaseName& case_name) {
    Case one{name_of_scenario(campaign.spec, entry)};
    one.index = case_name.index;
    one.seed = case_name.seed;
    one.site = campaign.spec.sites[entry.site];
    if (entry.day < campaign.spec.days.size())
        one.day = campaign.spec.days[entry.day].value;
    else if (is_over(campaign.spec, "climate"))
        one.weight = climate_of(campaign, one).weight();
    if (is_over(campaign.spec, "site")) one.weight *= one.site.weight;
    one.spacing = campaign.spec.spacings[entry.spacing].value;
    one.traits = campaign.spec.trait_sets[entry.traits].value;
    if (!campaign.spec.draws.empty()) {
        const auto& [name, draw] = campaign.spec.draws[entry.draw];
        one.draw_name = name;
        one.drawn = std::make_shared<const Campaign>(
            with_keys(campaign, factors_of(draw), draw.values));
    }
    add_stages(campaign_in(campaign, one), one);
    return one;
}

}  // namespace

std::vector<Case> scenarios(const Case& chosen) {
    return chosen.scenarios.empty() ? std::vector{chosen} : chosen.scenarios;
}

std::vector<Case> evaluated_cases(const Case& chosen) {
    std::vector<Case> evaluated;
    for (const Case& scenario : scenarios(chosen))
        if (scenario.stages.empty())
            evaluated.push_back(scenario);
        else
            evaluated.insert(evaluated.end(), scenario.stages.begin(),
                             scenario.stages.end());
    return evaluated;
}

std::size_t count_cases(const Spec& spec) {
    return Axes(spec).size();
}

CaseName case_name(const Spec& spec, std::size_t index) {
    CaseName one = name_of_scenario(spec, entries_of(Axes(spec), index));
    if (is_over(spec, "site")) one.site_name = "all";
    if (is_over(spec, "day") || is_over(spec, "climate")) one.day_name = "all";
    if (is_over(spec, "spacing")) one.spacing_name = "all";
    set_name(one);
    one.index = static_cast<int>(index);
    one.seed = derive_seed(spec.seed, one.name);
    return one;
}

Cases::Cases(const Campaign& campaign)
    : campaign_(&campaign), count_(count_cases(campaign.spec)) {}

CaseName Cases::name(std::size_t i) const {
    return case_name(campaign_->spec, first_ + i);
}

std::vector<CaseName> Cases::names() const {
    std::vector<CaseName> list;
    list.reserve(count_);
    for (std::size_t i = 0; i < count_; ++i) list.push_back(name(i));
    return list;
}

Case Cases::at(std::size_t i) const {
    if (i >= count_) throw std::out_of_range("there is no such case");
    const Campaign& campaign = *campaign_;
    const CaseName named = name(i);
    const Axes axes(campaign.spec);
    const AxisEntries entry = entries_of(axes, first_ + i);
    if (campaign.spec.objective.over.empty())
        return scenario_of(campaign, entry, named);
    // If the entries of an axis are scenarios, the case uses all of them.
    const auto entries = [](std::size_t of_cases, std::size_t count,
                            std::size_t index) {
        std::vector<std::size_t> places(of_cases == 1 ? count : 1);
        std::iota(places.begin(), places.end(), of_cases == 1 ? 0 : index);
        return places;
    };
    const std::size_t draws = campaign.spec.draws.size();
    std::vector<Case> scenarios;
    for (const std::size_t site :
         entries(axes.sites, campaign.spec.sites.size(), entry.site))
        for (const std::size_t day :
             entries(axes.days,
                     campaign.spec.days.size() + campaign.spec.climates.size(),
                     entry.day))
            for (const std::size_t spacing :
                 entries(axes.spacings, campaign.spec.spacings.size(),
                         entry.spacing))
                for (std::size_t draw = 0;
                     draw < std::max<std::size_t>(1, draws); ++draw) {
                    Case scenario =
                        scenario_of(campaign,
                                    {site, day, spacing, entry.traits,
                                     entry.replicate, draw},
                                    named);
                    if (scenario.weight > 0)
                        scenarios.push_back(std::move(scenario));
                }
    Case one = scenarios.front();
    static_cast<CaseName&>(one) = named;
    one.stages.clear();
    one.scenarios = std::move(scenarios);
    return one;
}

std::optional<Case> Cases::find(const std::string& name) const {
    for (std::size_t i = 0; i < count_; ++i)
        if (this->name(i).name == name) return at(i);
    return std::nullopt;
}

Cases Cases::part(std::size_t first, std::size_t count) const {
    IDEOTYPE_EXPECT(first + count <= count_);
    Cases some = *this;
    some.first_ += first;
    some.count_ = count;
    return some;
}

Cases Cases::only(int index, const std::string& path) const {
    if (index < 0 || index >= static_cast<int>(count_))
        throw wrong_usage(
            "there is no case {}; {} has cases 0 to {} (see ideotype check "
            "--cases)",
            index, path, count_ - 1);
    return part(static_cast<std::size_t>(index), 1);
}

Cases cases(const Campaign& campaign) {
    return Cases(campaign);
}

Case case_at(const Campaign& campaign, int index, const std::string& path) {
    return Cases(campaign).only(index, path).front();
}

LightSeries light_of(const Campaign& campaign, const Case& chosen) {
    if (!chosen.scenarios.empty())
        return light_of(campaign, chosen.scenarios.front());
    if (campaign.spec.climates.empty()) {
        LightSeries series =
            clear_days(chosen.site, chosen.day, campaign.spec.par_fraction);
        if (campaign.water)
            estimate_air(series, chosen.site, campaign.spec.par_fraction);
        return series;
    }
    for (const SiteWeather& weather : campaign.spec.weathers)
        if (weather.site == chosen.site.name &&
            weather.climate == chosen.day_name) {
            LightSeries series = to_series(weather, chosen.site);
            for (const auto& [name, climate] : campaign.spec.climates)
                if (name == chosen.day_name) {
                    series.wind_height =
                        climate.wind_height.value_or(series.wind_height);
                    series.co2 = climate.co2.value_or(series.co2);
                }
            if (campaign.water)
                estimate_air(series, chosen.site, campaign.spec.par_fraction);
            return chosen.stage ? at_stage(campaign, chosen, std::move(series))
                                : series;
        }
    throw Error("the campaign has no weather for case " + chosen.name);
}

std::vector<int> bred_rows(const Campaign& campaign) {
    std::vector<bool> is_taken(
        static_cast<std::size_t>(campaign.spec.field.rows));
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
                        static_cast<std::size_t>(campaign.spec.field.plants);
    for (const ComponentEntry& each : campaign.components)
        count -= static_cast<std::size_t>(each.standing.mixed);
    return count;
}

}  // namespace ideotype
