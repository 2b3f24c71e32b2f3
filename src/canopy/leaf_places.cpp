// SPDX-License-Identifier: Apache-2.0
#include "leaf_places.hpp"

#include <cmath>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/estimate.hpp"

namespace ideotype {

LeafPlaces::LeafPlaces(const Pieces& pieces, const LitLeaves& lit, bool is_each)
    : of(pieces.count) {
    IDEOTYPE_EXPECT(pieces.like.size() == pieces.count &&
                    pieces.area.size() == pieces.count);
    IDEOTYPE_EXPECT(lit.groups.size() >= pieces.count);
    for (std::uint32_t v = 0; v < pieces.count; ++v) {
        if (is_each || pieces.like[v] == v) {
            of[v] = static_cast<std::uint32_t>(index.size());
            index.push_back(0);
            group.push_back(pieces.group[v]);
            row.push_back(pieces.row.empty() ? 0 : pieces.row[v]);
            height.push_back(pieces.height[v]);
            if (!pieces.width.empty()) width.push_back(pieces.width[v]);
            absorptance.push_back(
                lit.par.optics.of(lit.groups[v].material).most_absorbed());
        } else {
            of[v] = of[pieces.like[v]];
        }
        IDEOTYPE_EXPECT(pieces.like[v] <= v);
        const double of_piece = pieces.area[v] / lit.scene.ground_area();
        index[of[v]] += of_piece;
        per_index.push_back(of_piece > 0 ? 1 / of_piece : 0);
    }
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
            IDEOTYPE_EXPECT(v < pieces);
            if (light[v] == 0) met.push_back(v);
            light[v] += energy;
        }
        parts[r].reserve(met.size());
        for (const std::uint32_t v : met) {
            sum[v] += light[v];
            parts[r].push_back({v, std::exchange(light[v], 0.)});
        }
    }
}

namespace {

//! Pools each place with a number of neighbours on its leaf.
std::vector<std::uint32_t> joined(const LeafPlaces& places,
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

//! Returns the relative variance of mean diffuse light over pooled places,
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

std::vector<std::uint32_t> join(const LeafPlaces& places,
                                const std::vector<Tally>& tallies) {
    constexpr double well_known = 0.1;
    constexpr std::uint32_t most = 64;
    const std::size_t n = tallies.size();
    if (n == 1) return joined(places, 1);
    const std::vector<double> light = all_diffuse(places, tallies);
    for (std::uint32_t size = 1;; size *= 2) {
        std::vector<std::uint32_t> first = joined(places, size);
        if (size == most ||
            relative_variance(places, first, light, n) <= well_known)
            return first;
    }
}

}  // namespace

ExpectedLight::ExpectedLight(const LeafPlaces& places,
                             const std::vector<Tally>& tallies)
    : places_(places), first_(join(places, tallies)), scale_(places.count()) {
    for (std::size_t p = 0; p < places.count(); ++p)
        scale_[first_[p]] +=
            places.index[p] * static_cast<double>(tallies.size());
    for (double& scale : scale_) scale = scale > 0 ? 1 / scale : 0;
}

std::vector<double> ExpectedLight::of(const DiffuseLight& light) const {
    IDEOTYPE_EXPECT(light.sum.size() == places_.pieces());
    std::vector<double> sum(places_.count()), expected;
    for (std::size_t v = 0; v < places_.pieces(); ++v)
        sum[first_[places_.of[v]]] += light.sum[v];
    for (const std::uint32_t first : first_)
        expected.push_back(scale_[first] * sum[first]);
    return expected;
}

}  // namespace ideotype
