// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ideotype/canopy/water.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Returns values divided by their sum; zeros if that is 0.
std::vector<double> shares_of(std::vector<double> values) {
    const double sum = std::reduce(values.begin(), values.end());
    for (double& x : values) x = sum > 0 ? x / sum : 0;
    return values;
}

//! The leaves that exchange water, as shares of their area.
struct LeafShares {
    std::vector<double> groups, layers, rows;
};

LeafShares shares_of(const std::vector<LeafGroup>& leaves,
                     const CanopyLeafArea& area) {
    std::vector<double> groups(leaves.size());
    const std::size_t rows = area.rows.size() / leaves.size();
    std::vector<double> of_rows(rows);
    for (std::size_t g = 0; g < leaves.size(); ++g) {
        if (!leaves[g].exchanges_water()) continue;
        groups[g] = area.groups[g];
        for (std::size_t row = 0; row < rows; ++row)
            of_rows[row] += area.rows[row * leaves.size() + g];
    }
    return {shares_of(std::move(groups)), shares_of(area.layers),
            shares_of(std::move(of_rows))};
}

//! Multiplies the flux of the leaves that exchange water, step by step. Other
//! organs have the same share of the flux in all steps.
void multiply(const std::vector<double>& factors,
              const std::vector<double>& amounts,
              const std::vector<LeafGroup>& leaves, FluxTally& tally) {
    double of_leaves = 0, all = 0;
    for (std::size_t g = 0; g < leaves.size(); ++g) {
        all += tally.groups[g];
        if (leaves[g].exchanges_water()) of_leaves += tally.groups[g];
    }
    const double share = all > 0 ? of_leaves / all : 1;
    double before = 0, after = 0;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        before += amounts[i] * tally.steps[i];
        after += amounts[i] * tally.steps[i] * factors[i];
        tally.steps[i] *= 1 + share * (factors[i] - 1);
    }
    const double factor = before > 0 ? after / before : 1;
    for (std::size_t g = 0; g < leaves.size(); ++g)
        if (leaves[g].exchanges_water()) tally.groups[g] *= factor;
    for (auto* part : {&tally.layers, &tally.rows})
        for (double& x : *part) x *= 1 + share * (factor - 1);
}

//! Adds to the flux of the leaves that exchange water, step by step.
void add(const std::vector<double>& differences,
         const std::vector<double>& amounts, const LeafShares& shares,
         FluxTally& tally) {
    double sum = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        tally.steps[i] += differences[i];
        sum += amounts[i] * differences[i];
    }
    const auto add_to = [&](std::vector<double>& parts,
                            const std::vector<double>& share) {
        for (std::size_t i = 0; i < parts.size(); ++i)
            parts[i] += share[i] * sum;
    };
    add_to(tally.groups, shares.groups);
    add_to(tally.layers, shares.layers);
    add_to(tally.rows, shares.rows);
}

}  // namespace

double change_of(const std::vector<ClosedStomata>& closed, LeafFlux flux,
                 std::size_t step, Closure closure) {
    const auto last = static_cast<double>(closed.size() + 1);
    IDEOTYPE_EXPECT(closure >= 0 && closure <= last);
    const bool is_factor = changes_by_factor(flux);
    const auto at = [&](std::size_t i) {
        if (i == 0) return is_factor ? 1. : 0.;
        if (i > closed.size() && is_factor) return 0.;
        return closed[std::min(i, closed.size()) - 1]
                     [static_cast<std::size_t>(flux)][step];
    };
    const auto below = static_cast<std::size_t>(std::floor(closure));
    const double part = closure - static_cast<double>(below);
    return part > 0 ? std::lerp(at(below), at(below + 1), part) : at(below);
}

void close_stomata(const std::vector<Closure>& closures,
                   const std::vector<LeafGroup>& leaves,
                   const CanopyLeafArea& area, const LightSeries& series,
                   CanopyFluxes& fluxes) {
    IDEOTYPE_EXPECT(fluxes.tallies.size() == leaf_fluxes &&
                    closures.size() == series.steps.size());
    const LeafShares shares = shares_of(leaves, area);
    for (std::size_t k = 0; k < leaf_fluxes; ++k) {
        const auto flux = static_cast<LeafFlux>(k);
        std::vector<double> amounts;
        for (const TimeStep& step : series.steps)
            amounts.push_back(amount_of(flux, step) / series.days);
        std::vector<double> changes;
        for (std::size_t i = 0; i < closures.size(); ++i)
            changes.push_back(change_of(fluxes.closed, flux, i, closures[i]));
        for (FluxTally& tally : fluxes.tallies[k])
            if (changes_by_factor(flux))
                multiply(changes, amounts, leaves, tally);
            else
                add(changes, amounts, shares, tally);
    }
}

}  // namespace ideotype
