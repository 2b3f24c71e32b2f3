// SPDX-License-Identifier: Apache-2.0
#include "leaf_places.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! Combines pieces that are the same part of identical plants. Each part is a
//! place until join().
//! @param is_each whether each piece is a separate part
void LeafPlaces::match(const Pieces& pieces, const LitLeaves& lit,
                       bool is_each) {
    IDEOTYPE_EXPECT(pieces.like.size() == pieces.count &&
                    pieces.area.size() == pieces.count);
    IDEOTYPE_EXPECT(lit.groups.size() >= pieces.count);
    const bool has_width = !pieces.width.empty();
    for (std::uint32_t v = 0; v < pieces.count; ++v) {
        IDEOTYPE_EXPECT(pieces.like[v] <= v);
        if (is_each || pieces.like[v] == v) {
            of[v] = static_cast<std::uint32_t>(index.size());
            group.push_back(pieces.group[v]);
            row.push_back(pieces.row.empty() ? 0 : pieces.row[v]);
            for (auto* sum : {&index, &height}) sum->push_back(0);
            if (has_width) width.push_back(0);
            absorptance.push_back(
                lit.par.optics.of(lit.groups[v].material).most_absorbed());
        } else {
            of[v] = of[pieces.like[v]];
        }
        const double of_piece = pieces.area[v] / lit.scene.ground_area();
        index[of[v]] += of_piece;
        height[of[v]] += of_piece * pieces.height[v];
        if (has_width) width[of[v]] += of_piece * pieces.width[v];
        per_index.push_back(of_piece > 0 ? 1 / of_piece : 0);
    }
    part = of;
    part_index = index;
    part_height = height;
    for (std::size_t j = 0; j < part_index.size(); ++j)
        if (part_index[j] > 0) part_height[j] /= part_index[j];
    first_part.resize(count() + 1);
    std::iota(first_part.begin(), first_part.end(), std::size_t{0});
}

DiffuseLight::DiffuseLight(const std::vector<Tally>& tallies, int source,
                           std::size_t pieces)
    : parts(tallies.size()), sum(pieces) {
    if (source < 0) return;
    const auto s = static_cast<std::size_t>(source);
    std::vector<double> light(pieces);
    std::vector<std::uint32_t> met;
    for (std::size_t r = 0; r < tallies.size(); ++r) {
        IDEOTYPE_EXPECT(s < tallies[r].leaf_light.size());
        met.clear();
        for (const auto& [v, energy] : tallies[r].leaf_light[s].diffuse) {
            IDEOTYPE_EXPECT(v < pieces && energy > 0);
            if (light[v] == 0) met.push_back(v);
            light[v] += energy;
        }
        parts[r].reserve(met.size());
        for (const std::uint32_t v : met) {
            if (sum[v] == 0) lit.push_back(v);
            sum[v] += light[v];
            parts[r].push_back({v, std::exchange(light[v], 0.)});
        }
    }
}

namespace {

//! Returns the first place of the neighbours with which each place is joined.
std::vector<std::uint32_t> first_of_joined(const LeafPlaces& places,
                                           std::uint32_t size) {
    std::vector<std::uint32_t> first(places.count());
    std::uint32_t start = 0;
    for (std::uint32_t p = 0; p < places.count(); ++p) {
        if (p > 0 && (places.group[p] != places.group[p - 1] ||
                      places.row[p] != places.row[p - 1]))
            start = p;
        first[p] = p - (p - start) % size;
    }
    return first;
}

//! Returns all light except direct beams, [place][randomisation].
std::vector<double> all_diffuse(const LeafPlaces& places,
                                const std::vector<Tally>& tallies) {
    const std::size_t n = tallies.size();
    std::vector<double> light(places.count() * n);
    for (std::size_t r = 0; r < n; ++r)
        for (const LeafLight& source : tallies[r].leaf_light)
            for (const auto& [v, energy] : source.diffuse)
                light[places.of[v] * n + r] += energy;
    return light;
}

//! Returns the relative variance of the mean diffuse light of joined places,
//! weighted by leaf area.
double relative_variance(const LeafPlaces& places,
                         const std::vector<std::uint32_t>& first,
                         const std::vector<double>& light, std::size_t n) {
    std::vector<double> of_joined(light.size()), index(places.count());
    for (std::size_t p = 0; p < places.count(); ++p) {
        index[first[p]] += places.index[p];
        for (std::size_t r = 0; r < n; ++r)
            of_joined[first[p] * n + r] += light[p * n + r];
    }
    double sum = 0, all = 0;
    for (std::size_t p = 0; p < places.count(); ++p) {
        const Estimate mean = estimate({&of_joined[p * n], n});
        all += index[p];
        // A place hit by paths of a single randomisation has a relative
        // variance of 1.
        sum +=
            index[p] *
            (mean.mean > 0 ? std::pow(mean.standard_error / mean.mean, 2) : 1);
    }
    return all > 0 ? sum / all : 0;
}

//! Returns the first place of those to be joined, so that their mean light is
//! known well.
std::vector<std::uint32_t> known_well(const LeafPlaces& places,
                                      const std::vector<Tally>& tallies) {
    constexpr double well_known = 0.1;
    constexpr std::uint32_t most = 64;
    const std::vector<double> light = all_diffuse(places, tallies);
    for (std::uint32_t size = 1;; size *= 2) {
        std::vector<std::uint32_t> first = first_of_joined(places, size);
        if (size == most || relative_variance(places, first, light,
                                              tallies.size()) <= well_known)
            return first;
    }
}

}  // namespace

LeafPlaces::LeafPlaces(const Pieces& pieces, const LitLeaves& lit,
                       const std::vector<Tally>& tallies)
    : of(pieces.count), randomisations_(static_cast<double>(tallies.size())) {
    match(pieces, lit, tallies.size() == 1);
    if (tallies.size() > 1) join(known_well(*this, tallies));
    take_means();
}

//! Joins places with the first of their neighbours, in which sums are kept.
void LeafPlaces::join(const std::vector<std::uint32_t>& first) {
    std::vector<std::uint32_t> number(count());
    std::size_t kept = 0;
    for (std::size_t p = 0; p < first.size(); ++p) {
        if (first[p] != p) {
            const std::uint32_t to = number[p] = number[first[p]];
            for (auto* sum : {&index, &height, &width})
                if (!sum->empty()) (*sum)[to] += (*sum)[p];
            continue;
        }
        number[p] = static_cast<std::uint32_t>(kept);
        for (auto* each : {&index, &height, &width, &absorptance})
            if (!each->empty()) (*each)[kept] = (*each)[p];
        group[kept] = group[p];
        row[kept] = row[p];
        first_part[kept++] = p;
    }
    first_part[kept] = first.size();
    first_part.resize(kept + 1);
    for (auto* each : {&index, &height, &width, &absorptance})
        each->resize(std::min(each->size(), kept));
    group.resize(kept);
    row.resize(kept);
    for (std::uint32_t& place : of) place = number[place];
}

//! Divides the sums of heights and widths by the area of places.
void LeafPlaces::take_means() {
    for (auto* sum : {&height, &width})
        for (std::size_t p = 0; p < sum->size(); ++p)
            if (index[p] > 0) (*sum)[p] /= index[p];
}

std::vector<double> LeafPlaces::expected(const DiffuseLight& light) const {
    IDEOTYPE_EXPECT(light.sum.size() == pieces());
    std::vector<double> mean(count());
    for (std::size_t v = 0; v < pieces(); ++v) mean[of[v]] += light.sum[v];
    for (std::size_t p = 0; p < count(); ++p)
        mean[p] = index[p] > 0 ? mean[p] / (index[p] * randomisations_) : 0;
    return mean;
}

}  // namespace ideotype
