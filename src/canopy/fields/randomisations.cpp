// SPDX-License-Identifier: Apache-2.0
#include "randomisations.hpp"

#include <algorithm>
#include <memory>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

void scale(std::vector<double>& all, double by) {
    for (double& x : all) x *= by;
}

//! Returns the mean of items that consist of the given lists of numbers.
template <class Item, class... Parts>
Item mean_of_parts(const std::vector<Item>& all, Parts... parts) {
    IDEOTYPE_EXPECT(!all.empty());
    Item mean = all.front();
    const auto take = [&](auto part) {
        for (std::size_t i = 1; i < all.size(); ++i)
            add(mean.*part, all[i].*part);
        scale(mean.*part, 1. / static_cast<double>(all.size()));
    };
    (take(parts), ...);
    return mean;
}

}  // namespace

std::vector<double> mean_of(const std::vector<std::vector<double>>& all) {
    IDEOTYPE_EXPECT(!all.empty());
    std::vector<double> mean = all.front();
    for (std::size_t i = 1; i < all.size(); ++i) add(mean, all[i]);
    scale(mean, 1. / static_cast<double>(all.size()));
    return mean;
}

Tally mean_of(const std::vector<Tally>& tallies) {
    const auto n = static_cast<double>(tallies.size());
    Tally mean = mean_of_parts(tallies, &Tally::groups, &Tally::layers);
    for (std::size_t s = 0; s < mean.parts.size(); ++s) {
        for (std::size_t i = 1; i < tallies.size(); ++i)
            add(mean.parts[s], tallies[i].parts[s]);
        scale(mean.parts[s], 1 / n);
    }
    for (std::size_t i = 1; i < tallies.size(); ++i) {
        const Tally& more = tallies[i];
        for (std::size_t s = 0; s < mean.sources.size(); ++s)
            mean.sources[s] += more.sources[s];
        mean.adaxial += more.adaxial;
        mean.abaxial += more.abaxial;
        mean.rays += more.rays;
        mean.next_rays += more.next_rays;
    }
    for (Budget& budget : mean.sources) budget *= 1 / n;
    mean.adaxial /= n;
    mean.abaxial /= n;
    IDEOTYPE_EXPECT(mean.resolution != nullptr);
    Resolution resolution = *mean.resolution;
    scale(resolution.path_energy, 1 / n);
    mean.resolution = std::make_shared<const Resolution>(resolution);
    return mean;
}

FluxTally mean_of(const std::vector<FluxTally>& tallies) {
    return mean_of_parts(tallies, &FluxTally::groups, &FluxTally::layers,
                         &FluxTally::steps, &FluxTally::rows);
}

LightClasses mean_of(const std::vector<LightClasses>& classes) {
    return mean_of_parts(classes, &LightClasses::sunlit, &LightClasses::shaded);
}

std::vector<std::vector<double>> light_of_rows(
    const std::vector<Tally>& tallies, const Pieces& pieces,
    const std::vector<Group>& groups) {
    std::vector<std::vector<double>> all;
    if (pieces.rows == 0) return all;
    IDEOTYPE_EXPECT(pieces.row.size() == groups.size());
    for (const Tally& tally : tallies) {
        std::vector<double>& rows = all.emplace_back(pieces.rows);
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (groups[g].id.is_leaf()) rows[pieces.row[g]] += tally.groups[g];
    }
    return all;
}

void add_up_pieces(std::vector<Tally>& tallies, const Pieces& pieces,
                   std::size_t groups) {
    if (tallies.empty()) return;
    const auto add_up = [&](const std::vector<double>& of_pieces, auto add) {
        IDEOTYPE_EXPECT(of_pieces.size() == pieces.group.size());
        std::vector<double> of_groups(groups);
        for (std::size_t v = 0; v < of_pieces.size(); ++v)
            add(of_groups[pieces.group[v]], of_pieces[v]);
        return of_groups;
    };
    Resolution resolution = *tallies.front().resolution;
    resolution.groups = add_up(resolution.groups, [](double& all, double part) {
        all = std::max(all, part);
    });
    const auto shared = std::make_shared<const Resolution>(resolution);
    for (Tally& tally : tallies) {
        tally.groups = add_up(tally.groups,
                              [](double& all, double light) { all += light; });
        tally.leaf_light.clear();
        tally.resolution = shared;
    }
}

}  // namespace ideotype
