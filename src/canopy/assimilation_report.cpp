// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! The number at the end of a leaf's name; 0 if there is none.
std::size_t leaf_number(const std::string& name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    constexpr std::string_view leaf = "leaf";
    constexpr std::size_t most_digits = 4;
    if (digits == name.size() || name.size() - digits > most_digits ||
        digits < leaf.size() ||
        name.compare(digits - leaf.size(), leaf.size(), leaf) != 0)
        return 0;
    return std::stoul(name.substr(digits));
}

}  // namespace

std::vector<LeafRates> rates_of_groups(
    const Photosynthesis& photosynthesis, const std::vector<Group>& groups,
    const std::vector<double>& leaf_area_index) {
    // Groups without a number are all one leaf.
    std::vector<std::size_t> leaf(groups.size());
    std::size_t leaves = 1;
    bool is_numbered = true;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        if (groups[g].tissue != Tissue::leaf) continue;
        const std::size_t number = leaf_number(groups[g].name);
        is_numbered = is_numbered && number > 0;
        leaf[g] = std::max<std::size_t>(number, 1) - 1;
        leaves = std::max(leaves, leaf[g] + 1);
    }
    if (!is_numbered) {
        if (photosynthesis.rates.size() > 1)
            throw Error(
                "photosynthesis has rates by leaf, but groups of leaves have "
                "no numbers (as in leaf01, the lowest); name them so");
        leaf.assign(groups.size(), 0);
        leaves = 1;
    }
    std::vector<double> index(leaves);
    for (std::size_t g = 0; g < groups.size(); ++g)
        index[leaf[g]] += leaf_area_index[g];
    const std::vector<LeafRates> rates = rates_of_leaves(photosynthesis, index);
    std::vector<LeafRates> result;
    for (std::size_t g = 0; g < groups.size(); ++g)
        result.push_back(rates[leaf[g]]);
    return result;
}

Air air_of(const TimeStep& step, const Photosynthesis& photosynthesis) {
    Air air;
    if (!photosynthesis.follows_weather) return air;
    air.temperature = step.temperature.value_or(air.temperature);
    air.humidity = step.humidity.value_or(air.humidity);
    return air;
}

Respiration AssimilationReport::all_respiration() const {
    Respiration sum;
    for (const Respiration& each : respiration) {
        sum.in_light += each.in_light;
        sum.at_night += each.at_night;
    }
    return sum;
}

double AssimilationReport::carbon_loss() const {
    const Respiration all = all_respiration();
    return all.in_light + all.at_night + building;
}

double AssimilationTally::gross() const {
    return std::accumulate(groups.begin(), groups.end(), 0.);
}

namespace {

//! Of leaves in the dark, over a mean day.
Respiration respiration(const LeafRates& rates, double leaf_area_index,
                        const LightSeries& series,
                        const Photosynthesis& photosynthesis) {
    if (!(leaf_area_index > 0)) return {};
    const double scale =
        mol_per_umol * leaf_area_index / static_cast<double>(series.days);
    Respiration result;
    double known = 0;
    for (const TimeStep& step : series.steps) {
        const double amount =
            scale * step.seconds *
            dark_respiration(rates, air_of(step, photosynthesis).temperature);
        if (step.is_lit())
            result.in_light += amount;
        else
            result.at_night += amount;
        known += step.seconds;
    }
    // Nights that are left out have no weather.
    constexpr double day = 86400;
    result.at_night += scale * std::max(0., series.days * day - known) *
                       dark_respiration(rates, Air{}.temperature);
    return result;
}

}  // namespace

AssimilationReport report(std::vector<AssimilationTally> tallies,
                          const std::vector<LeafRates>& rates,
                          const std::vector<double>& leaf_area_index,
                          const SeriesIllumination& light,
                          const Photosynthesis& photosynthesis) {
    AssimilationReport result;
    const auto over = [&](const auto& figure) {
        std::vector<double> replicates;
        for (const AssimilationTally& tally : tallies)
            replicates.push_back(figure(tally));
        return estimate(replicates);
    };
    const auto each = [&](std::vector<double> AssimilationTally::*part) {
        std::vector<Estimate> all;
        for (std::size_t i = 0; i < (tallies.front().*part).size(); ++i)
            all.push_back(
                over([&](const AssimilationTally& t) { return (t.*part)[i]; }));
        return all;
    };
    result.gross = over([](const AssimilationTally& t) { return t.gross(); });
    result.groups = each(&AssimilationTally::groups);
    result.layers = each(&AssimilationTally::layers);
    const LightSeries& series = light.series;
    const auto of_steps = [&](const auto& lists, const auto& weight) {
        std::vector<Estimate> all;
        for (const std::vector<std::size_t>& steps : lists)
            all.push_back(over([&](const AssimilationTally& t) {
                double sum = 0;
                for (const std::size_t i : steps) sum += weight(i) * t.steps[i];
                return sum;
            }));
        return all;
    };
    result.hours = of_steps(series.steps_of_hours(),
                            [&](std::size_t) { return 1. / series.days; });
    if (series.days > 1)
        result.dates = of_steps(series.steps_of_dates(), [&](std::size_t i) {
            return mol_per_umol * series.steps[i].seconds;
        });
    for (std::size_t g = 0; g < rates.size(); ++g)
        result.respiration.push_back(
            respiration(rates[g], leaf_area_index[g], series, photosynthesis));
    for (const double index : leaf_area_index)
        result.building +=
            photosynthesis.building_cost * index / photosynthesis.building_days;
    result.tallies = std::move(tallies);
    return result;
}

}  // namespace ideotype
