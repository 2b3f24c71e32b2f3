// SPDX-License-Identifier: Apache-2.0
#include "unbounded_genes.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

//! Width of the parabolic part at a bound, relative to the range.
constexpr double margin = bound_margin;

//! Maps a coordinate to a share of the range. The map is linear in the middle,
//! and parabolic near the bounds, where the parts join with equal slopes.
double fold(double coordinate) {
    // The map is periodic: each period runs up and down the range once.
    constexpr double period = 2 * (1 + 2 * margin);
    double x = std::remainder(coordinate + margin, period);
    x = std::abs(x) - margin;  // within [-margin, 1 + margin]
    if (x < margin) return (x + margin) * (x + margin) / (4 * margin);
    if (x > 1 - margin)
        return 1 - (1 + margin - x) * (1 + margin - x) / (4 * margin);
    return x;
}

//! Inverts fold() on its first period.
double unfold(double share) {
    IDEOTYPE_EXPECT(share >= 0 && share <= 1);
    if (share < margin) return 2 * std::sqrt(margin * share) - margin;
    if (share > 1 - margin)
        return 1 + margin - 2 * std::sqrt(margin * (1 - share));
    return share;
}

}  // namespace

UnboundedGenes::UnboundedGenes(const GeneSpace& genes) : genes_(genes) {
    for (std::size_t i = 0; i < genes.size(); ++i)
        if (genes[i].can_vary())
            (genes[i].is_choice() ? choices_ : free_).push_back(i);
}

std::vector<double> UnboundedGenes::to_coordinates(const Genome& genome) const {
    IDEOTYPE_EXPECT(genome.size() == genes_.size());
    std::vector<double> coordinates;
    for (const std::size_t i : free_) {
        const Gene& gene = genes_[i];
        const double share = share_of(gene, genome[i]);
        coordinates.push_back(gene.is_circular || gene.is_discrete()
                                  ? share
                                  : unfold(std::clamp(share, 0.0, 1.0)));
    }
    return coordinates;
}

std::vector<double> UnboundedGenes::first_steps() const {
    return mapped(
        free_, [&](std::size_t i) { return genes_[i].is_circular ? .5 : 1.; });
}

Genome UnboundedGenes::to_genome(const std::vector<double>& coordinates,
                                 Genome original) const {
    IDEOTYPE_EXPECT(coordinates.size() == free_.size());
    IDEOTYPE_EXPECT(original.size() == genes_.size());
    for (std::size_t k = 0; k < free_.size(); ++k) {
        const Gene& gene = genes_[free_[k]];
        const double range = gene.upper - gene.lower;
        const double x = coordinates[k];
        if (gene.is_discrete()) {
            original[free_[k]] = value_at(gene, std::clamp(x, 0.0, 1.0));
            continue;
        }
        original[free_[k]] =
            gene.is_circular
                ? wrapped(gene, gene.lower + (x - std::floor(x)) * range)
                : std::clamp(gene.lower + fold(x) * range, gene.lower,
                             gene.upper);
    }
    return original;
}

}  // namespace ideotype
