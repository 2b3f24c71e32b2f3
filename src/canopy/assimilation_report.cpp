// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <utility>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

//! Returns the leaf index of each group, 0 for the lowest leaf. If any group
//! has no rank, all groups count as one leaf.
std::vector<std::size_t> leaves_of(const std::vector<Group>& groups,
                                   const std::vector<std::size_t>& some) {
    std::vector<std::size_t> leaf;
    for (const std::size_t g : some) {
        if (groups[g].id.rank == 0)
            return std::vector<std::size_t>(some.size(), 0);
        leaf.push_back(groups[g].id.rank - 1);
    }
    return leaf;
}

//! Sets the entries of groups that are non-leaf organs of a component.
void set_organs(const Component& component, std::uint32_t number,
                const std::vector<Group>& groups,
                std::vector<LeafGroup>& result) {
    if (!component.plant) return;
    const std::vector<PlantOrgan> organs = list_organs(*component.plant);
    std::uint32_t present = 0;
    for (std::size_t place = 0; place < organs.size(); ++place) {
        const PlantOrgan& organ = organs[place];
        if (!organ.is_present) continue;
        ++present;
        if (!organ.tissue.is_living()) continue;
        const auto is_own = [&](std::size_t g) {
            return groups[g].id.component == number &&
                   groups[g].id.organ == present;
        };
        std::size_t parts = 0;
        for (std::size_t g = 0; g < groups.size(); ++g)
            parts += is_own(g) ? 1 : 0;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            if (!is_own(g)) continue;
            // If each face is a group, the mass is divided equally among them.
            const double share =
                1 / (static_cast<double>(parts) * component.ground_per_plant);
            LeafGroup& group = result[g];
            group.photosynthesis = &*component.photosynthesis;
            group.component = number;
            group.roots = component.roots;
            group.ear_share = component.ear_share;
            group.organ = {organ.tissue, share * organ.mass};
            group.rates = without_respiration(scaled(
                component.photosynthesis->rates.back(), organ.tissue.capacity));
            if (!component.built_organs.empty())
                group.built = share * component.built_organs.at(place);
        }
    }
}

//! Returns the total leaf area index of the component to which a group belongs.
double lai_of_component(const std::vector<LeafGroup>& leaves, std::size_t group,
                        std::span<const double> leaf_area_index) {
    double sum = 0;
    for (std::size_t g = 0; g < leaves.size(); ++g)
        if (leaves[g].exchanges_water() &&
            leaves[g].component == leaves[group].component)
            sum += leaf_area_index[g];
    return sum;
}

//! Returns the leaf area of a group's component in a field relative to plants
//! that do not deviate from their line.
double share_of_line(const std::vector<LeafGroup>& leaves, std::size_t group,
                     std::span<const double> leaf_area_index) {
    const double line = leaves[group].lai_of_line;
    return line > 0 ? lai_of_component(leaves, group, leaf_area_index) / line
                    : 1;
}

//! Returns the amount of a group that respires: leaf area index, or dry mass of
//! an organ per ground area [kg m-2].
double respiring(const std::vector<LeafGroup>& leaves, std::size_t group,
                 std::span<const double> leaf_area_index) {
    return leaves[group].organ
               ? leaves[group].organ->mass *
                     share_of_line(leaves, group, leaf_area_index)
               : leaf_area_index[group];
}

//! Returns the dry mass per leaf area [kg m-2]; for an organ, 1.
double unit_mass(const LeafGroup& group) {
    constexpr double kg_per_g = 1e-3;
    return group.organ ? 1 : group.photosynthesis->leaf_mass * kg_per_g;
}

//! Returns the dark respiration rate, including that of roots, of a leaf [umol
//! m-2 s-1] or of the dry mass of an organ [umol kg-1 s-1].
double respiration_rate(const LeafGroup& group, double temperature) {
    const double rate = group.organ
                            ? maintenance_respiration(
                                  group.organ->tissue.maintenance, temperature)
                            : dark_respiration(group.rates, temperature);
    if (!(group.roots.share > 0)) return rate;
    return rate +
           group.roots.share * unit_mass(group) *
               maintenance_respiration(group.roots.maintenance, temperature);
}

//! Returns the carbon cost, including that of roots, of building leaf area [mol
//! m-2] or the dry mass of an organ [mol kg-1].
double building_cost(const LeafGroup& group) {
    // WOFOST, temperate maize: CVR.
    constexpr double of_roots = carbon_per_carbohydrate / 0.69;
    const double cost =
        group.organ ? group.organ->tissue.construction * carbon_per_carbohydrate
                    : leaf_building_cost(group.photosynthesis->leaf_mass);
    return cost + group.roots.share * unit_mass(group) * of_roots;
}

//! Returns the leaf area, or the dry mass of an organ, that is built per ground
//! area: the whole amount, unless plants grow.
double built(const std::vector<LeafGroup>& leaves, std::size_t group,
             std::span<const double> leaf_area_index) {
    return leaves[group].built
               ? *leaves[group].built *
                     share_of_line(leaves, group, leaf_area_index)
               : respiring(leaves, group, leaf_area_index);
}

}  // namespace

namespace {

//! Returns the share of a component's plants that are in a part of a field.
double share_of_plants(const std::vector<LeafGroup>& leaves, std::size_t group,
                       std::span<const double> part,
                       std::span<const double> whole) {
    const double all = lai_of_component(leaves, group, whole);
    return all > 0 ? lai_of_component(leaves, group, part) / all : 1;
}

}  // namespace

CarbonLoss loss_of_part(const CarbonLoss& loss,
                        const std::vector<LeafGroup>& leaves, std::size_t group,
                        std::span<const double> part,
                        std::span<const double> whole) {
    const double of_plants = share_of_plants(leaves, group, part, whole);
    const bool is_leaf = !leaves[group].organ && whole[group] > 0;
    CarbonLoss result =
        loss.scaled(is_leaf ? part[group] / whole[group] : of_plants);
    if (leaves[group].built) result.building = of_plants * loss.building;
    return result;
}

std::vector<LeafGroup> leaf_groups(const Scene& scene,
                                   const std::vector<Group>& groups,
                                   const std::vector<double>& leaf_area_index) {
    IDEOTYPE_EXPECT(leaf_area_index.size() == groups.size());
    std::vector<LeafGroup> result(groups.size());
    for (std::uint32_t c = 0; c < scene.components.size(); ++c) {
        const auto& photosynthesis = scene.components[c].photosynthesis;
        if (!photosynthesis) continue;
        set_organs(scene.components[c], c, groups, result);
        std::vector<std::size_t> own;
        bool is_ranked = true;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            const SurfaceId& id = groups[g].id;
            if (id.component != c || !id.is_leaf()) continue;
            own.push_back(g);
            is_ranked = is_ranked && id.rank > 0;
        }
        if (own.empty()) continue;
        if (!is_ranked && photosynthesis->rates.size() > 1)
            throw Error(
                "photosynthesis has rates by leaf, but groups of leaves have "
                "no numbers (as in leaf01, the lowest); name them so");
        const std::vector<std::size_t> leaf = leaves_of(groups, own);
        std::vector<double> index(1 +
                                  *std::max_element(leaf.begin(), leaf.end()));
        for (std::size_t i = 0; i < own.size(); ++i)
            index[leaf[i]] += leaf_area_index[own[i]];
        const std::vector<LeafRates> rates =
            rates_of_leaves(*photosynthesis, index);
        const std::vector<double>& built = scene.components[c].built;
        IDEOTYPE_EXPECT(built.empty() || built.size() >= index.size());
        for (std::size_t i = 0; i < own.size(); ++i) {
            result[own[i]] = {rates[leaf[i]],
                              &*photosynthesis,
                              {},
                              {},
                              scene.components[c].roots,
                              scene.components[c].ear_share,
                              c};
            if (!built.empty())
                result[own[i]].built =
                    built[leaf[i]] / scene.components[c].ground_per_plant;
        }
    }
    if (scene.varies())
        for (std::size_t g = 0; g < groups.size(); ++g)
            result[g].lai_of_line =
                lai_of_component(result, g, leaf_area_index);
    return result;
}

Air air_of(const TimeStep& step, const Photosynthesis& photosynthesis) {
    Air air;
    if (!photosynthesis.follows_weather) return air;
    air.temperature = step.temperature.value_or(air.temperature);
    air.humidity = step.humidity.value_or(air.humidity);
    return air;
}

CarbonLoss& CarbonLoss::operator+=(const CarbonLoss& more) {
    in_light += more.in_light;
    at_night += more.at_night;
    building += more.building;
    of_ears += more.of_ears;
    return *this;
}

CarbonLoss CarbonLoss::scaled(double share) const {
    return {share * in_light, share * at_night, share * building,
            share * of_ears};
}

CarbonLoss sum_of(const std::vector<CarbonLoss>& losses) {
    CarbonLoss sum;
    for (const CarbonLoss& each : losses) sum += each;
    return sum;
}

std::vector<ComponentAssimilation> by_component(
    const AssimilationReport& report, const std::vector<Group>& groups,
    std::size_t components) {
    IDEOTYPE_EXPECT(report.losses.size() == groups.size());
    std::vector<ComponentAssimilation> all;
    for (std::uint32_t c = 0; c < components; ++c) {
        ComponentAssimilation& one = all.emplace_back();
        const std::vector<FluxTally>& tallies = report.gross.tallies;
        std::vector<double> gross(tallies.size()), uptake(tallies.size());
        one.loss_by_randomisation.resize(report.losses_by_randomisation.size());
        for (std::size_t g = 0; g < groups.size(); ++g) {
            if (groups[g].id.component != c) continue;
            one.loss += report.losses[g];
            for (std::size_t r = 0; r < gross.size(); ++r) {
                gross[r] += tallies[r].groups[g];
                uptake[r] += report.before_losses().tallies[r].groups[g];
            }
            for (std::size_t r = 0; r < one.loss_by_randomisation.size(); ++r)
                one.loss_by_randomisation[r] += report.losses_in(r)[g];
        }
        one.gross = estimate(gross);
        one.uptake = estimate(uptake);
    }
    return all;
}

FluxTally& FluxTally::operator+=(const FluxTally& more) {
    for (const auto part : {&FluxTally::groups, &FluxTally::layers,
                            &FluxTally::steps, &FluxTally::rows}) {
        IDEOTYPE_EXPECT((this->*part).size() == (more.*part).size());
        for (std::size_t i = 0; i < (this->*part).size(); ++i)
            (this->*part)[i] += (more.*part)[i];
    }
    return *this;
}

double FluxTally::sum() const {
    return std::accumulate(groups.begin(), groups.end(), 0.);
}

namespace {

//! Returns the respiration of leaves, or of an organ, during one step of a mean
//! day.
//! @param amount see respiring()
double respiration(const LeafGroup& group, double amount,
                   const LightSeries& series, const TimeStep& step) {
    return mol_per_umol * amount / static_cast<double>(series.days) *
           step.seconds *
           respiration_rate(group,
                            air_of(step, *group.photosynthesis).temperature);
}

//! Returns the respiration of leaves, or of an organ, over a mean day.
//! @param amount see respiring()
CarbonLoss respiration(const LeafGroup& group, double amount,
                       const LightSeries& series) {
    if (!(amount > 0)) return {};
    const double scale =
        mol_per_umol * amount / static_cast<double>(series.days);
    CarbonLoss result;
    double known = 0;
    for (const TimeStep& step : series.steps) {
        const double lost = respiration(group, amount, series, step);
        if (step.is_lit())
            result.in_light += lost;
        else
            result.at_night += lost;
        known += step.seconds;
    }
    if (series.grows) return result;  // other stages add the rest
    // The series has no weather for the nights that it omits.
    constexpr double day = 86400;
    result.at_night += scale * std::max(0., series.days * day - known) *
                       respiration_rate(group, Air{}.temperature);
    return result;
}

//! Returns gross assimilation less respiration after silking, by randomisation.
//! @param tallies tallies of AssimilationReport::before_losses()
std::vector<double> late_net(const std::vector<FluxTally>& tallies,
                             const std::vector<LeafGroup>& leaves,
                             const std::vector<double>& leaf_area_index,
                             const LightSeries& series) {
    std::vector<double> net(tallies.size());
    for (std::size_t i = 0; i < series.steps.size(); ++i)
        if (const TimeStep& step = series.steps[i]; step.is_late)
            for (std::size_t r = 0; r < tallies.size(); ++r)
                net[r] += mol_per_umol * tallies[r].steps[i] * step.seconds /
                          series.days;
    for (std::size_t g = 0; g < leaves.size(); ++g) {
        if (!leaves[g].photosynthesis) continue;
        double of_unit = 0;
        for (const TimeStep& step : series.steps)
            if (step.is_late)
                of_unit += respiration(leaves[g], 1, series, step);
        for (std::size_t r = 0; r < tallies.size(); ++r) {
            const std::vector<double>& own = tallies[r].leaf_area;
            net[r] -= of_unit *
                      respiring(leaves, g, own.empty() ? leaf_area_index : own);
        }
    }
    return net;
}

//! Returns gross assimilation less respiration on each date, by randomisation.
//! @param tallies tallies of AssimilationReport::before_losses()
std::vector<std::vector<double>> net_of_dates(
    const std::vector<FluxTally>& tallies, const std::vector<LeafGroup>& leaves,
    const std::vector<double>& leaf_area_index, const LightSeries& series) {
    const auto steps_of_dates = series.steps_of_dates();
    std::vector<std::vector<double>> net(
        tallies.size(), std::vector<double>(steps_of_dates.size()));
    for (std::size_t d = 0; d < steps_of_dates.size(); ++d) {
        for (const std::size_t i : steps_of_dates[d])
            for (std::size_t r = 0; r < tallies.size(); ++r)
                net[r][d] += mol_per_umol * tallies[r].steps[i] *
                             series.steps[i].seconds;
        for (std::size_t g = 0; g < leaves.size(); ++g) {
            if (!leaves[g].photosynthesis) continue;
            double of_unit = 0;
            for (const std::size_t i : steps_of_dates[d])
                of_unit += series.days *
                           respiration(leaves[g], 1, series, series.steps[i]);
            for (std::size_t r = 0; r < tallies.size(); ++r) {
                const std::vector<double>& own = tallies[r].leaf_area;
                net[r][d] -=
                    of_unit *
                    respiring(leaves, g, own.empty() ? leaf_area_index : own);
            }
        }
    }
    return net;
}

//! Returns losses by randomisation. They depend on the leaf area of the field.
std::vector<std::vector<CarbonLoss>> losses_by_randomisation(
    const AssimilationReport& report, const std::vector<LeafGroup>& leaves,
    const std::vector<double>& leaf_area_index) {
    std::vector<std::vector<CarbonLoss>> all;
    for (const FluxTally& tally : report.before_losses().tallies) {
        std::vector<CarbonLoss>& losses = all.emplace_back();
        for (std::size_t g = 0; g < leaves.size(); ++g)
            losses.push_back(loss_of_part(report.losses[g], leaves, g,
                                          tally.leaf_area, leaf_area_index));
    }
    return all;
}

//! Adds the respiration of ears, in proportion to the carbon available for
//! them.
void add_ears(const std::vector<LeafGroup>& leaves,
              AssimilationReport& report) {
    if (std::ranges::none_of(
            leaves, [](const LeafGroup& x) { return x.ear_share > 0; }))
        return;
    const std::vector<FluxTally>& tallies = report.before_losses().tallies;
    auto& by_randomisation = report.losses_by_randomisation;
    if (by_randomisation.empty())
        by_randomisation.assign(tallies.size(), report.losses);
    for (std::size_t g = 0; g < leaves.size(); ++g) {
        double sum = 0;
        for (std::size_t r = 0; r < tallies.size(); ++r) {
            CarbonLoss& loss = by_randomisation[r][g];
            loss.of_ears =
                leaves[g].ear_share * (tallies[r].groups[g] - loss.respired());
            sum += loss.of_ears;
        }
        report.losses[g].of_ears = sum / static_cast<double>(tallies.size());
    }
}

}  // namespace

FluxReport report(std::vector<FluxTally> tallies, const LightSeries& series,
                  double (*amount_of)(const TimeStep& step)) {
    IDEOTYPE_EXPECT(!tallies.empty());
    IDEOTYPE_EXPECT(tallies.front().steps.size() == series.steps.size());
    FluxReport result;
    const auto over = [&](const auto& figure) {
        return estimate(mapped(tallies, figure));
    };
    const auto each = [&](std::vector<double> FluxTally::*part) {
        std::vector<Estimate> all;
        for (std::size_t i = 0; i < (tallies.front().*part).size(); ++i)
            all.push_back(
                over([&](const FluxTally& t) { return (t.*part)[i]; }));
        return all;
    };
    result.sum = over(&FluxTally::sum);
    result.groups = each(&FluxTally::groups);
    result.layers = each(&FluxTally::layers);
    const auto of_steps = [&](const auto& lists, const auto& weight) {
        std::vector<Estimate> all;
        for (const std::vector<std::size_t>& steps : lists)
            all.push_back(over([&](const FluxTally& t) {
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
            return amount_of(series.steps[i]);
        });
    result.tallies = std::move(tallies);
    return result;
}

AssimilationReport report(std::vector<FluxTally> uptake,
                          const std::vector<FluxTally>& respired,
                          const std::vector<LeafGroup>& leaves,
                          const std::vector<double>& leaf_area_index,
                          const SeriesIllumination& light, bool is_by_date) {
    IDEOTYPE_EXPECT(leaves.size() == leaf_area_index.size());
    AssimilationReport result;
    const LightSeries& series = light.series;
    const auto amount = [](const TimeStep& step) {
        return mol_per_umol * step.seconds;
    };
    if (respired.empty()) {
        result.gross = report(std::move(uptake), series, amount);
    } else {
        IDEOTYPE_EXPECT(respired.size() == uptake.size());
        std::vector<FluxTally> gross = uptake;
        for (std::size_t r = 0; r < gross.size(); ++r) gross[r] += respired[r];
        result.gross = report(std::move(gross), series, amount);
        result.uptake = report(std::move(uptake), series, amount);
    }
    for (std::size_t g = 0; g < leaves.size(); ++g) {
        const LeafGroup& group = leaves[g];
        CarbonLoss& loss = result.losses.emplace_back();
        result.dry_mass.push_back(0);
        if (!group.photosynthesis) continue;
        const Photosynthesis* photosynthesis = group.photosynthesis;
        IDEOTYPE_EXPECT(photosynthesis->building_days > 0);
        loss =
            respiration(group, respiring(leaves, g, leaf_area_index), series);
        const double amount_built = built(leaves, g, leaf_area_index);
        result.dry_mass.back() = unit_mass(group) * amount_built;
        loss.building =
            building_cost(group) * amount_built /
            (group.built ? series.days : photosynthesis->building_days);
    }
    const std::vector<FluxTally>& tallies = result.before_losses().tallies;
    if (!tallies.front().leaf_area.empty())
        result.losses_by_randomisation =
            losses_by_randomisation(result, leaves, leaf_area_index);
    if (is_by_date)
        result.net_of_dates =
            net_of_dates(tallies, leaves, leaf_area_index, series);
    add_ears(leaves, result);
    if (series.grows) {
        result.late_net = late_net(tallies, leaves, leaf_area_index, series);
        for (std::size_t r = 0; r < tallies.size(); ++r)
            result.late_net[r] -= sum_of(result.losses_in(r)).of_ears;
    }
    return result;
}

}  // namespace ideotype
