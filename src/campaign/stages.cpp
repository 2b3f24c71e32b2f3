// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign.hpp"
#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/physiology/temperature.hpp"
#include "season_days.hpp"
#include "spec/problems.hpp"

namespace ideotype {

namespace {

//! Returns the thermal time since emergence at the middle of each hour of a
//! series. It is negative before emergence.
std::vector<double> thermal_times(const Growth& growth, const Date& emergence,
                                  int later, const LightSeries& series) {
    const auto begin = to_day(emergence) + std::chrono::days(later);
    std::vector<double> times;
    double sum = 0;
    for (const TimeStep& step : series.steps) {
        if (to_day(step.date) < begin) {
            times.push_back(-1);
            continue;
        }
        const double temperature = step.temperature.value_or(growth.base);
        const double time = daily_thermal_time(growth, {&temperature, 1}) *
                            step.seconds / 86400;
        times.push_back(sum + time / 2);
        sum += time;
    }
    return times;
}

//! The season of a crop: its hours from emergence to the day of maturity.
struct Season {
    std::size_t begin = 0, end = 0;  //!< first step, and end of the range
    std::vector<double> times;       //!< thermal times of all steps
};

Season season_of(const Campaign& campaign, const Case& chosen,
                 const LightSeries& series) {
    const Growth& growth = *campaign.crop.growth;
    Season season;
    season.times = thermal_times(growth, climate_of(campaign, chosen).emergence,
                                 0, series);
    const auto& times = season.times;
    season.begin = static_cast<std::size_t>(
        std::ranges::find_if(times, [](double x) { return x >= 0; }) -
        times.begin());
    season.end = static_cast<std::size_t>(
        std::lower_bound(times.begin(), times.end(), maturity_time(growth)) -
        times.begin());
    if (season.end < times.size()) {
        const Date last = series.steps[season.end].date;
        while (season.end < times.size() &&
               series.steps[season.end].date == last)
            ++season.end;
    }
    return season;
}

//! Returns the thermal times of each component in all steps; 0 for components
//! that do not grow.
std::vector<std::vector<double>> all_ages(const Campaign& campaign,
                                          const Case& one, const Season& season,
                                          const LightSeries& series) {
    std::vector<std::vector<double>> ages{season.times};
    for (std::size_t c = 1; c <= campaign.components.size(); ++c)
        ages.push_back(
            growth_of(campaign, c)
                ? thermal_times(*growth_of(campaign, c),
                                climate_of(campaign, one).emergence,
                                campaign.components[c - 1].standing.later,
                                series)
                : std::vector<double>(season.times.size()));
    return ages;
}

//! @param of_crop thermal time of the main crop
std::vector<double> ages_at(const std::vector<std::vector<double>>& ages,
                            std::size_t step, double of_crop) {
    std::vector<double> component_ages{of_crop};
    for (std::size_t c = 1; c < ages.size(); ++c)
        component_ages.push_back(ages[c][step]);
    return component_ages;
}

std::vector<double> ages_before(const Campaign& campaign) {
    return std::vector<double>(1 + campaign.components.size(), -1);
}

//! Returns the weight of a stage at a thermal time, for linear interpolation
//! between stages.
double weight(const Stage& stage, double time) {
    if (time < stage.at)
        return stage.before ? std::max(0., (time - *stage.before) /
                                               (stage.at - *stage.before))
                            : 1;
    return stage.after
               ? std::max(0., (*stage.after - time) / (*stage.after - stage.at))
               : 1;
}

//! Returns, for each step, the fraction of the carbon assimilated by a
//! component that its ears will respire; 0 before silking. Ears are filled with
//! carbon N; their dry mass M grows by dM/dt = e N - e m' M, with dry matter
//! per carbon e and maintenance m' [mol kg-1 d-1]. Thus a fraction exp(-R) of
//! the carbon of time t remains at maturity, where R is the integral of e m'
//! from t to maturity. This fraction does not depend on N, so that stages can
//! be evaluated independently.
//! @param ages thermal times of the component
std::vector<double> respired_by_ears(const Growth& growth, const Season& season,
                                     const std::vector<double>& ages,
                                     const Photosynthesis& photosynthesis,
                                     const LightSeries& series) {
    std::vector<double> shares(ages.size());
    double left = 0;  // R
    for (std::size_t i = season.end; i-- > season.begin;) {
        const TimeStep& step = series.steps[i];
        if (ages[i] <= silking_time(growth)) break;
        shares[i] = 1 - std::exp(-left);
        if (ages[i] > maturity_time(growth)) continue;
        left +=
            dry_matter_per_carbon * mol_per_umol * step.seconds *
            maintenance_respiration(
                growth.ear_maintenance * maintenance_factor(growth, ages[i]),
                air_of(step, photosynthesis).temperature);
    }
    return shares;
}

//! Sets Stage::ear_shares of all stages to means over the steps that they
//! represent, weighted by light.
void set_ear_shares(const Campaign& campaign, const Season& season,
                    const std::vector<std::vector<double>>& ages,
                    const LightSeries& series, Case& one) {
    for (std::size_t c = 0; c <= campaign.components.size(); ++c) {
        const Growth* const growth = growth_of(campaign, c);
        const auto& photosynthesis =
            c == 0 ? campaign.photosynthesis
                   : campaign.components[c - 1].photosynthesis;
        const bool respires =
            growth && growth->ear_maintenance > 0 && photosynthesis;
        if (!respires) {
            for (Case& each : one.stages) each.stage->ear_shares.push_back(0);
            continue;
        }
        const std::vector<double> shares =
            respired_by_ears(*growth, season, ages[c], *photosynthesis, series);
        for (Case& stage_case : one.stages) {
            double sum = 0, all = 0;
            for (std::size_t i = season.begin; i < season.end; ++i) {
                const TimeStep& step = series.steps[i];
                const double light =
                    weight(*stage_case.stage, season.times[i]) * step.seconds *
                    (step.par.beam + step.par.diffuse);
                sum += light * shares[i];
                all += light;
            }
            stage_case.stage->ear_shares.push_back(all > 0 ? sum / all : 0);
        }
    }
}

}  // namespace

const Climate& climate_of(const Campaign& campaign, const Case& chosen) {
    return std::ranges::find_if(
               campaign.spec.climates,
               [&](const auto& each) { return each.name == chosen.day_name; })
        ->value;
}

const Growth* growth_of(const Campaign& campaign, std::size_t component) {
    const Crop& crop = component == 0
                           ? campaign.crop
                           : campaign.components.at(component - 1).crop;
    return crop.growth ? &*crop.growth : nullptr;
}

void add_stages(const Campaign& campaign, Case& one) {
    // crop.growth is not set in a draft campaign.
    if (!campaign.crop.growth || campaign.spec.climates.empty() ||
        !climate_of(campaign, one).grows())
        return;
    const LightSeries series = light_of(campaign, one);
    const Season season = season_of(campaign, one, series);
    const std::vector<StageTime> times =
        stage_times(campaign, one.spacing.row * one.spacing.plant,
                    season.times[season.end - 1]);
    const auto ages = all_ages(campaign, one, season, series);
    const Case whole = one;
    // Compute each stage with its share of the light that is intercepted in the
    // season.
    double sum = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
        const auto [at, interception] = times[k];
        Stage stage{static_cast<std::uint32_t>(k), at};
        if (k > 0) stage.before = times[k - 1].at;
        if (k + 1 < times.size()) stage.after = times[k + 1].at;
        const auto step = static_cast<std::size_t>(
            std::lower_bound(season.times.begin(),
                             season.times.begin() +
                                 static_cast<std::ptrdiff_t>(season.end - 1),
                             at) -
            season.times.begin());
        stage.day = static_cast<double>(step - season.begin) *
                    series.steps[step].seconds / 86400;
        stage.ages = ages_at(ages, step, at);
        stage.ages_before =
            k > 0 ? one.stages[k - 1].stage->ages : ages_before(campaign);
        stage.share = 0;
        for (std::size_t i = season.begin; i < season.end; ++i)
            stage.share +=
                weight(stage, season.times[i]) *
                (series.steps[i].par.beam + series.steps[i].par.diffuse);
        stage.share *= interception;
        sum += stage.share;
        one.stages.push_back(whole);
        one.stages.back().stage = std::move(stage);
    }
    for (Case& each : one.stages) each.stage->share /= sum;
    set_ear_shares(campaign, season, ages, series, one);
}

Stage stage_on(const Campaign& campaign, const Case& one,
               const std::variant<Date, double>& when) {
    if (one.stages.empty())
        throw wrong_usage(
            "plants of this campaign do not grow (there is no "
            "climate.emergence), so they have a single age; leave the age out");
    const LightSeries series = light_of(campaign, one);
    const Season season = season_of(campaign, one, series);
    const auto* date = std::get_if<Date>(&when);
    const auto begin = series.steps.begin();
    std::size_t step = 0;
    if (date) {
        const auto first =
            std::ranges::lower_bound(series.steps, *date, {}, &TimeStep::date);
        const auto last =
            std::ranges::upper_bound(series.steps, *date, {}, &TimeStep::date);
        step = static_cast<std::size_t>(first + (last - first) / 2 - begin);
    } else {
        step = static_cast<std::size_t>(
            std::ranges::lower_bound(season.times, std::get<double>(when)) -
            season.times.begin());
    }
    const bool is_in_season =
        date ? step < season.end && series.steps[step].date == *date &&
                   season.times[step] >= 0
             : std::get<double>(when) >= 0 && step < season.end;
    if (!is_in_season)
        throw wrong_usage(
            "{} is not in the season of these plants: they emerge on {}, and "
            "are {:.0f} deg C d old at its end on {}",
            date ? to_string(*date)
                 : fmt::format("{} deg C d", std::get<double>(when)),
            to_string(climate_of(campaign, one).emergence),
            season.times[season.end - 1],
            to_string(series.steps[season.end - 1].date));
    const auto ages = all_ages(campaign, one, season, series);
    Stage stage;
    stage.at = date ? season.times[step] : std::get<double>(when);
    stage.ages = ages_at(ages, step, stage.at);
    stage.ages_before = ages_before(campaign);
    stage.date = series.steps[step].date;
    return stage;
}

std::vector<SeasonDay> season_days(const Campaign& campaign,
                                   const Case& scenario) {
    const LightSeries series = light_of(campaign, scenario);
    const Season season = season_of(campaign, scenario, series);
    const Growth& growth = *campaign.crop.growth;
    std::vector<SeasonDay> days;
    for (std::size_t first = season.begin, last = 0; first < season.end;
         first = last) {
        SeasonDay& day = days.emplace_back();
        day.date = series.steps[first].date;
        for (last = first;
             last < season.end && series.steps[last].date == day.date;)
            ++last;
        const std::span steps(&series.steps[first], last - first);
        const auto hours = static_cast<double>(steps.size());
        day.thermal_time = season.times[first + steps.size() / 2];
        const double maintenance = growth.ear_maintenance *
                                   maintenance_factor(growth, day.thermal_time);
        AirOfDay air;
        for (const TimeStep& step : steps) {
            day.rain += step.rain.value_or(0);
            const double t = step.temperature.value_or(Air{}.temperature);
            day.filling += filling_rate(t) / hours;
            day.ear_maintenance += dry_matter_per_carbon * mol_per_umol *
                                   step.seconds *
                                   maintenance_respiration(maintenance, t);
            if (!campaign.water) continue;
            constexpr double mega = 1e-6;
            const double k = t + kelvin;
            air.temperature += t / hours;
            air.deficit += saturated_vapour(t) *
                           (1 - step.humidity.value_or(Air{}.humidity)) / hours;
            air.wind += *step.wind * 4.87 /
                        std::log(67.8 * series.wind_height - 5.42) / hours;
            air.pressure += (*step.pressure - AirOfDay{}.pressure) / hours;
            air.radiation += mega * step.seconds *
                             (step.par.beam + step.par.diffuse + step.nir.beam +
                              step.nir.diffuse);
            air.longwave_loss +=
                mega * step.seconds *
                (stefan_boltzmann * k * k * k * k - *step.longwave);
        }
        if (campaign.water) day.reference = reference_evapotranspiration(air);
    }
    return days;
}

bool fills_grain(const Campaign& campaign) {
    return campaign.crop.grain && campaign.photosynthesis &&
           plants_grow(campaign.spec) && campaign.components.empty();
}

LightSeries at_stage(const Campaign& campaign, const Case& chosen,
                     LightSeries series) {
    const Season season = season_of(campaign, chosen, series);
    const double silking = silking_time(*campaign.crop.growth);
    std::vector<TimeStep> steps;
    std::vector<Date> dates;
    for (std::size_t i = season.begin; i < season.end; ++i) {
        TimeStep step = series.steps[i];
        if (chosen.stage->date.value_or(step.date) != step.date) continue;
        if (dates.empty() || dates.back() != step.date)
            dates.push_back(step.date);
        step.seconds *= weight(*chosen.stage, season.times[i]);
        step.is_late = season.times[i] > silking;
        if (step.seconds > 0) steps.push_back(step);
    }
    series.steps = std::move(steps);
    series.days = static_cast<int>(dates.size());
    series.grows = true;
    return series;
}

}  // namespace ideotype
