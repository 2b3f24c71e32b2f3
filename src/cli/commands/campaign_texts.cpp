// SPDX-License-Identifier: Apache-2.0
#include "campaign_texts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/clock.hpp"
#include "run/evolve_case.hpp"
#include "run/progress.hpp"

namespace ideotype {

namespace {

constexpr std::array<int, 4> shown_workers{1, 2, 16, 128};

std::string clock(std::optional<double> hour) {
    return hour ? clock_time(*hour) : "-";
}

std::string known(const std::optional<double>& value, double factor,
                  const char* unit) {
    return value ? fmt::format("{:.1f} {}", factor * *value, unit) : "-";
}

void add_air(Json& row, const AirOverview& air) {
    row["wind"] =
        fmt::format("{:.1f} m/s at {:g} m", air.wind, air.wind_height);
    row["pressure"] = fmt::format("{:.1f} kPa", air.pressure);
    row["longwave"] = fmt::format("{:.0f} W m-2", air.longwave);
    row["CO2"] = fmt::format("{:g} umol mol-1", air.co2);
    row["estimated"] = fmt::format("{}", fmt::join(air.estimated, ", "));
}

//! Returns the part of a path or setting after the last slash.
std::string file_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

//! Formats a leaf parameter as "amax 50", or as "amax 40 .. 50" if leaves
//! differ.
std::string number_text(const LeafNumber& number) {
    Extent extent;
    for (const double value : number.values) extent.add(value);
    return fmt::format("{} {}", number.name, text_of(extent, "{:g}"));
}

//! Returns the photosynthesis model and the capacities of leaves. Each is
//! followed by the file that states it, or by "default".
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

//! Describes the leaf temperature.
std::string temperature_text(const Campaign& campaign) {
    if (campaign.water && campaign.water->has_leaf_temperature)
        return "at the temperature of their energy balance";
    if (campaign.spec.climates.empty() ||
        !campaign.photosynthesis->follows_weather)
        return fmt::format(
            "{:g} deg C{}", Air{}.temperature,
            campaign.spec.climates.empty() ? " on clear days" : "");
    return "at air temperature";
}

//! Describes the development stage of plants that do not grow, and the
//! photosynthetic capacity that leaves have at this age.
std::string static_age_text(const Campaign& campaign) {
    const double stage = campaign.spec.plant.stage;
    std::string text =
        stage == 1 ? "silking" : fmt::format("development stage {:g}", stage);
    if (const auto& growth = campaign.crop.growth)
        if (const double capacity =
                capacity_factor(*growth, find_thermal_time(*growth, stage));
            capacity != 1)
            text += fmt::format(" ({:g} of the capacity at silking)", capacity);
    return text;
}

//! Returns the number of plants in the first generation.
std::size_t first_generation(const Campaign& campaign) {
    const Case first = cases(campaign).front();
    return make_optimizer(campaign.search, search_space(campaign, first),
                          first.seed)
        ->size(0);
}

}  // namespace

Json json_of(const CampaignCost& cost, std::size_t cases) {
    Json json{{"evaluation_s", cost.usual},
              {"final_evaluation_s", cost.final},
              {"evaluations_per_case", cost.evaluations()},
              {"final_evaluations_per_case", cost.finalists}};
    for (const int workers : shown_workers)
        json["by_workers"].push_back(
            {{"workers", workers},
             {"one_case_s", cost.of_case(workers)},
             {"all_cases_s", cost.of_cases(cases, workers)}});
    return json;
}

std::string cost_text(const CampaignCost& cost) {
    return fmt::format(
        "{} evaluations of {:.1f} ms and the finalists: {} on one core",
        cost.evaluations(), cost.usual * 1e3, format_duration(cost.of_case(1)));
}

std::string cost_table(const CampaignCost& cost, std::size_t cases) {
    std::string text = fmt::format("{:>17}  {:>12}  {:>12}\n", "workers",
                                   "one case", cases == 1 ? "" : "all cases");
    for (const int workers : shown_workers)
        text += fmt::format(
            "{:>17}  {:>12}  {:>12}\n", workers,
            format_duration(cost.of_case(workers)),
            cases == 1 ? "" : format_duration(cost.of_cases(cases, workers)));
    return text;
}

std::vector<Json> rows_of(const std::vector<SkyOverview>& skies,
                          bool are_climates) {
    std::vector<Json> rows;
    for (const SkyOverview& sky : skies) {
        const Site& site = sky.site;
        Json& row = rows.emplace_back();
        row = {{"site", site.name},
               {"place", fmt::format("{} {} {} {}", std::abs(site.latitude),
                                     site.latitude < 0 ? 'S' : 'N',
                                     std::abs(site.longitude),
                                     site.longitude < 0 ? 'W' : 'E')},
               {are_climates ? "period" : "day", sky.day},
               {"days", sky.days}};
        if (are_climates) {
            row["PAR per day"] = fmt::format("{:.2f} MJ m-2", sky.par / 1e6);
            row["diffuse"] = fmt::format("{:.0f} %", 100 * sky.diffuse);
            row["temperature"] = known(sky.temperature, 1, "C");
            row["humidity"] = known(sky.humidity, 100, "%");
            if (sky.air) add_air(row, *sky.air);
        } else {
            row["elevation"] = fmt::format("{:.1f} deg", sky.sun.elevation);
            row["left out"] = fmt::format("{:.1f} %", 100 * sky.left_out);
            row["clock ahead"] = fmt::format("{:+.2f} h", clock_ahead(site));
        }
        row["clock"] = clock_name(site.utc_offset);
        row["sunrise"] = clock(sky.sun.sunrise);
        row["noon"] = clock(sky.sun.noon);
        row["sunset"] = clock(sky.sun.sunset);
    }
    return rows;
}

Json rows_of(const std::vector<StageOverview>& stages) {
    Json rows;
    for (const StageOverview& stage : stages)
        rows.push_back({{"period", stage.climate},
                        {"emergence", to_string(stage.emergence)},
                        {"day", fmt::format("{:.0f}", stage.stage.day)},
                        {"deg C d", fmt::format("{:.0f}", stage.stage.at)},
                        {"green LAI", fmt::format("{:.2f}", stage.green)},
                        {"dead LAI", fmt::format("{:.2f}", stage.dead)},
                        {"share of light",
                         fmt::format("{:.1f} %", 100 * stage.stage.share)}});
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
        return "leaves    absorb light; assimilation is not computed\n";
    std::string text;
    for (const StatedLeaves& leaves : campaign.leaves)
        text += fmt::format(
            "{:<10}{}{}, {}\n", text.empty() ? "leaves" : "",
            campaign.leaves.size() == 1 ? "" : "of " + leaves.crop + ": ",
            model_text(leaves), temperature_text(campaign));
    return text;
}

Json leaves_of(const Campaign& campaign) {
    const auto file_of = [](const std::string& file) {
        return file.empty() ? Json() : Json(file);
    };
    Json list = Json::array();
    for (const StatedLeaves& leaves : campaign.leaves) {
        Json numbers = Json::array();
        for (const LeafNumber& number : leaves.numbers)
            numbers.push_back({{"name", number.name},
                               {"values", number.values},
                               {"file", file_of(number.file)}});
        list.push_back({{"crop", leaves.crop},
                        {"model", leaves.model},
                        {"file", file_of(leaves.file)},
                        {"numbers", numbers},
                        {"temperature", temperature_text(campaign)}});
    }
    return list;
}

std::string growth_text(const Campaign& campaign, const Case& chosen) {
    const Case first = scenarios(chosen).front();
    if (first.stages.empty())
        return fmt::format(
            "growth    none: plants are those of the crop file on all days, "
            "with leaves as at {}\n",
            static_age_text(campaign));
    return fmt::format(
        "growth    from emergence on {} to maturity, in {} stages\n",
        to_string(climate_of(campaign, first).emergence), first.stages.size());
}

std::string search_text(const Campaign& campaign) {
    const SearchSettings& search = campaign.search;
    const std::size_t first = first_generation(campaign);
    return fmt::format(
        "search    {}, generations of {} plants{}{}, at most {} plants\n",
        name_of(search.optimizer), search.population,
        first == static_cast<std::size_t>(search.population)
            ? ""
            : fmt::format(" (the first of {})", first),
        search.streams == 1 ? ""
                            : fmt::format(" of {} streams", search.streams),
        static_cast<long long>(search.population) * campaign.stop.generations);
}

Json search_of(const Campaign& campaign) {
    const SearchSettings& search = campaign.search;
    return {{"optimizer", name_of(search.optimizer)},
            {"population", search.population},
            {"first_generation", first_generation(campaign)},
            {"streams", search.streams},
            {"most_plants", static_cast<long long>(search.population) *
                                campaign.stop.generations}};
}

}  // namespace ideotype
