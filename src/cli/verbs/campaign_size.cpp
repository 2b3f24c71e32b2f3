// SPDX-License-Identifier: Apache-2.0
#include "campaign_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/clock.hpp"
#include "ideotype/light/device.hpp"
#include "run/evaluator.hpp"
#include "run/progress.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

constexpr std::array<int, 4> shown_workers{1, 2, 16, 128};

std::string clock(std::optional<double> hour) {
    return hour ? clock_time(*hour) : "-";
}

//! Returns the mean of a value by day, weighted by light.
std::string by_day(const LightSeries& series,
                   std::optional<double> TimeStep::*value, double factor,
                   const std::string& unit) {
    double sum = 0, light = 0;
    for (const TimeStep& step : series.steps) {
        const double par = step.par.beam + step.par.diffuse;
        if (!(step.*value)) return "-";
        sum += par * *(step.*value);
        light += par;
    }
    return fmt::format("{:.1f} {}", factor * sum / light, unit);
}

//! Adds wind, pressure, longwave radiation and CO2 of a climate if its weather
//! tells any of them or an estimate exists.
void add_air(Json& row, const Campaign& campaign, const Site& site,
             LightSeries series) {
    const TimeStep& first = series.steps.front();
    if (!first.wind && !first.pressure && !first.longwave &&
        series.co2 == LightSeries{}.co2)
        return;
    estimate_air(series, site, campaign.spec.par_fraction);
    const auto mean = [&](std::optional<double> TimeStep::*value) {
        double sum = 0;
        for (const TimeStep& step : series.steps) sum += *(step.*value);
        return sum / static_cast<double>(series.steps.size());
    };
    row["wind"] = fmt::format("{:.1f} m/s at {:g} m", mean(&TimeStep::wind),
                              series.wind_height);
    row["pressure"] = fmt::format("{:.1f} kPa", mean(&TimeStep::pressure));
    row["longwave"] = fmt::format("{:.0f} W m-2", mean(&TimeStep::longwave));
    row["CO2"] = fmt::format("{:g} umol mol-1", series.co2);
    row["estimated"] = fmt::format("{}", fmt::join(series.estimated, ", "));
}

//! Returns the sun on the middle date of a day or climate at its site, and the
//! light that a climate has or a day leaves out.
Json sky_of(const Campaign& campaign, const Case& chosen,
            const LightSeries& series) {
    const bool is_climate = !campaign.spec.climates.empty();
    const Site& site = chosen.site;
    const std::vector<Date> dates =
        is_climate ? series.dates() : chosen.day.dates;
    const Daylight sun = daylight(site, dates[dates.size() / 2]);
    Json row{{"site", site.name},
             {"place", fmt::format("{} {} {} {}", std::abs(site.latitude),
                                   site.latitude < 0 ? 'S' : 'N',
                                   std::abs(site.longitude),
                                   site.longitude < 0 ? 'W' : 'E')},
             {is_climate ? "period" : "day", chosen.day_name},
             {"days", dates.size()}};
    if (is_climate) {
        row["PAR per day"] =
            fmt::format("{:.2f} MJ m-2", series.incident() / 1e6);
        row["diffuse"] =
            fmt::format("{:.0f} %", 100 * series.diffuse() / series.incident());
        row["temperature"] = by_day(series, &TimeStep::temperature, 1, "C");
        row["humidity"] = by_day(series, &TimeStep::humidity, 100, "%");
        add_air(row, campaign, site, series);
    } else {
        row["elevation"] = fmt::format("{:.1f} deg", sun.elevation);
        row["left out"] =
            fmt::format("{:.1f} %", 100 * share_left_out(site, chosen.day));
        row["clock ahead"] = fmt::format("{:+.2f} h", clock_ahead(site));
    }
    row["clock"] = clock_name(site.utc_offset);
    row["sunrise"] = clock(sun.sunrise);
    row["noon"] = clock(sun.noon);
    row["sunset"] = clock(sun.sunset);
    return row;
}

//! Returns the name of the file in a path or in a setting.
std::string file_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

//! Returns the number of leaves as "50", or as "40 .. 50" if leaves differ.
std::string number_text(const LeafNumber& number) {
    Extent extent;
    for (const double value : number.values) extent.add(value);
    return fmt::format("{} {}", number.name, extent.text("{:g}"));
}

//! Returns the model and the capacities of leaves, each with the file that
//! states it or the word "default".
std::string model_text(const StatedLeaves& leaves) {
    std::vector<std::pair<std::string, std::string>> parts{
        {leaves.model, leaves.file}};
    for (const LeafNumber& number : leaves.numbers)
        if (number.is_capacity)
            parts.emplace_back(number_text(number), number.file);
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto& [part, file] = parts[i];
        text += (i == 0 ? "" : ", ") + part;
        if (i + 1 == parts.size() || parts[i + 1].second != file)
            text += fmt::format(" ({})",
                                file.empty() ? "default" : file_name(file));
    }
    return text;
}

//! Returns what determines the temperature of leaves.
std::string temperature_text(const Campaign& campaign) {
    if (campaign.water && campaign.water->has_leaf_temperature)
        return "with the temperature of their energy balance";
    if (campaign.spec.climates.empty() ||
        !campaign.photosynthesis->follows_weather)
        return fmt::format(
            "{:g} deg C{}", Air{}.temperature,
            campaign.spec.climates.empty() ? " on clear days" : "");
    return "with the temperature of the air";
}

//! Returns the development stage of plants that do not grow, and the capacity
//! of the crop's leaves if these have aged.
std::string static_age_text(const Campaign& campaign) {
    const double stage = campaign.spec.plant.stage;
    std::string text =
        stage == 1 ? "silking" : fmt::format("development stage {:g}", stage);
    if (const auto& growth = campaign.crop.growth)
        if (const double capacity =
                capacity_factor(*growth, thermal_time_of(*growth, stage));
            capacity != 1)
            text += fmt::format(" ({:g} of the capacity at silking)", capacity);
    return text;
}

}  // namespace

//! The fastest of a few evaluations counts, since the first warms up and other
//! processes may use the core.
CampaignCost::CampaignCost(const Campaign& campaign, const Case& chosen)
    : population(campaign.search.population),
      generations(campaign.stop.generations),
      finalists(1 + campaign.final_rule.candidates) {
    CanopyEvaluator evaluator(campaign, Device::supported_isas().back());
    // Time that needs no second measurement [s].
    constexpr double long_time = 1;
    const auto measure = [&](int times, Task task) {
        task.case_index = static_cast<std::uint32_t>(chosen.index);
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < times && !(i > 0 && least > long_time); ++i) {
            const double began = now();
            evaluator.evaluate(task, baseline_genome(campaign));
            least = std::min(least, now() - began);
        }
        return least;
    };
    usual = measure(3, {});
    Task last;
    last.is_final = true;
    final = measure(1, last);
}

double CampaignCost::of_case(int workers) const {
    const int rounds = (population + workers - 1) / workers;
    const int final_rounds = (finalists + workers - 1) / workers;
    return usual * static_cast<double>(generations) * rounds +
           final * final_rounds;
}

double CampaignCost::of_cases(std::size_t cases, int workers) const {
    const double all = static_cast<double>(cases) * of_case(1) / workers;
    return std::max(all, of_case(workers));
}

Json CampaignCost::json(std::size_t cases) const {
    Json json{{"evaluation_s", usual},
              {"final_evaluation_s", final},
              {"evaluations_per_case",
               static_cast<long long>(generations) * population},
              {"final_evaluations_per_case", finalists}};
    for (const int workers : shown_workers)
        json["by_workers"].push_back(
            {{"workers", workers},
             {"one_case_s", of_case(workers)},
             {"all_cases_s", of_cases(cases, workers)}});
    return json;
}

std::string CampaignCost::text() const {
    return fmt::format(
        "{} evaluations of {:.1f} ms and the finalists: {} on one core",
        static_cast<long long>(generations) * population, usual * 1e3,
        format_duration(of_case(1)));
}

std::string CampaignCost::table(std::size_t cases) const {
    std::string text = fmt::format("{:>17}  {:>12}  {:>12}\n", "workers",
                                   "one case", cases == 1 ? "" : "all cases");
    for (const int workers : shown_workers)
        text += fmt::format(
            "{:>17}  {:>12}  {:>12}\n", workers,
            format_duration(of_case(workers)),
            cases == 1 ? "" : format_duration(of_cases(cases, workers)));
    return text;
}

Stands stands_of(const Campaign& campaign, double leaf_area) {
    Stands all;
    for (const auto& [name, spacing] : campaign.spec.spacings) {
        all.period_x.add(campaign.spec.field.rows * spacing.row);
        all.period_y.add(campaign.spec.field.plants * spacing.plant);
        all.lai.add(leaf_area / (spacing.row * spacing.plant));
    }
    // Many cases share a site and a day.
    std::set<std::pair<std::string, std::string>> of_cases, seen;
    const Cases some = cases(campaign);
    for (std::size_t i = 0; i < some.size(); ++i) {
        const CaseName name = some.name(i);
        if (!of_cases.emplace(name.site_name, name.day_name).second) continue;
        for (const Case& each : scenarios(some[i])) {
            if (!seen.emplace(each.site.name, each.day_name).second) continue;
            const LightSeries light = light_of(campaign, each);
            all.steps.add(static_cast<double>(light.steps.size()));
            all.par.add(light.incident());
            all.diffuse.add(light.diffuse() / light.incident());
            all.sky.push_back(sky_of(campaign, each, light));
        }
    }
    return all;
}

Json season_of(const Campaign& campaign, const Case& chosen) {
    Json rows;
    for (const Case& each : scenarios(chosen))
        for (const Case& at : each.stages) {
            const Scene scene = scene_of(campaign, at);
            double green = 0, dead = 0;
            for (const Component& one : scene.components) {
                green += lai_of_line(one.mesh, one.ground_per_plant);
                dead += dead_area(one.mesh) / one.ground_per_plant;
            }
            rows.push_back(
                {{"period", each.day_name},
                 {"emergence", to_string(climate_of(campaign, each).emergence)},
                 {"day", fmt::format("{:.0f}", at.stage->day)},
                 {"deg C d", fmt::format("{:.0f}", at.stage->at)},
                 {"green LAI", fmt::format("{:.2f}", green)},
                 {"dead LAI", fmt::format("{:.2f}", dead)},
                 {"share of light",
                  fmt::format("{:.1f} %", 100 * at.stage->share)}});
        }
    return rows;
}

std::string objective_text(const Campaign& campaign) {
    std::string text;
    const std::vector<double>& factors = campaign.spec.objective.sole.empty()
                                             ? campaign.spec.objective.weights
                                             : campaign.spec.objective.sole;
    for (const ObjectiveEntry& objective : objectives_of(campaign)) {
        text += fmt::format(
            "{}{} {}", text.empty() ? "objective " : ", ",
            objective.sense == Sense::maximise ? "maximise" : "minimise",
            objective.name);
        for (std::size_t c = 0; c < factors.size(); ++c)
            text += fmt::format(
                "{}{} {} {:g}", c == 0 ? " of " : " + ",
                c == 0 ? campaign.crop.baseline.name
                       : campaign.components[c - 1].name,
                campaign.spec.objective.sole.empty() ? "times" : "over",
                factors[c]);
    }
    return text + (campaign.spec.objective.sole.empty()
                       ? "\n"
                       : ": the land equivalent ratio\n");
}

std::string leaves_text(const Campaign& campaign) {
    if (campaign.leaves.empty())
        return "leaves    absorb light; assimilation is not evaluated\n";
    std::string text;
    for (const StatedLeaves& each : campaign.leaves)
        text += fmt::format(
            "{:<10}{}{}, {}\n", text.empty() ? "leaves" : "",
            campaign.leaves.size() == 1 ? "" : "of " + each.crop + ": ",
            model_text(each), temperature_text(campaign));
    return text;
}

Json leaves_of(const Campaign& campaign) {
    const auto file_of = [](const std::string& file) {
        return file.empty() ? Json() : Json(file);
    };
    Json all = Json::array();
    for (const StatedLeaves& each : campaign.leaves) {
        Json numbers = Json::array();
        for (const LeafNumber& number : each.numbers)
            numbers.push_back({{"name", number.name},
                               {"values", number.values},
                               {"file", file_of(number.file)}});
        all.push_back({{"crop", each.crop},
                       {"model", each.model},
                       {"file", file_of(each.file)},
                       {"numbers", numbers},
                       {"temperature", temperature_text(campaign)}});
    }
    return all;
}

std::string growth_text(const Campaign& campaign, const Case& chosen) {
    const Case first = scenarios(chosen).front();
    if (first.stages.empty())
        return fmt::format(
            "growth    none: plants are those of the crop file on all days, "
            "with leaves as at {}\n",
            static_age_text(campaign));
    return fmt::format(
        "growth    from emergence on {} to maturity, at {} "
        "stages\n",
        to_string(climate_of(campaign, first).emergence), first.stages.size());
}

std::string search_text(const Campaign& campaign) {
    const SearchSettings& search = campaign.search;
    const int first = first_generation(search);
    return fmt::format(
        "search    {}, generations of {} plants{}{}, at most {} plants\n",
        name_of(search.optimizer), search.population,
        first == search.population ? ""
                                   : fmt::format(" (the first of {})", first),
        search.streams == 1 ? ""
                            : fmt::format(" of {} streams", search.streams),
        static_cast<long long>(search.population) * campaign.stop.generations);
}

Json search_of(const Campaign& campaign) {
    const SearchSettings& search = campaign.search;
    return {{"optimizer", name_of(search.optimizer)},
            {"population", search.population},
            {"first_generation", first_generation(search)},
            {"streams", search.streams},
            {"most_plants", static_cast<long long>(search.population) *
                                campaign.stop.generations}};
}

}  // namespace ideotype
