// SPDX-License-Identifier: Apache-2.0
#include "population.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ideotype/core/contract.hpp"

namespace ideotype {

std::size_t count_free(const GeneSpace& genes) {
    return static_cast<std::size_t>(
        std::count_if(genes.begin(), genes.end(),
                      [](const Gene& gene) { return gene.is_free; }));
}

double wrapped(const Gene& gene, double value) {
    IDEOTYPE_EXPECT(gene.is_circular && gene.lower < gene.upper);
    IDEOTYPE_EXPECT(std::isfinite(value));
    const double range = gene.upper - gene.lower;
    const double turns = std::floor((value - gene.lower) / range);
    const double result = value - turns * range;
    // Rounding can move a tiny negative value to the upper end.
    return result < gene.upper ? std::max(result, gene.lower) : gene.lower;
}

double within(const Gene& gene, double value) {
    return gene.is_circular ? wrapped(gene, value)
                            : std::clamp(value, gene.lower, gene.upper);
}

double difference(const Gene& gene, double a, double b) {
    if (!gene.is_circular) return b - a;
    const double range = gene.upper - gene.lower;
    return std::remainder(b - a, range);
}

const char* name_of(Bound bound) {
    return bound == Bound::lower ? "lower" : "upper";
}

std::optional<Bound> find_bound(const Gene& gene, double value) {
    if (gene.is_circular || !gene.is_free) return std::nullopt;
    const double reach = bound_margin * (gene.upper - gene.lower);
    if (!(reach > 0)) return std::nullopt;
    if (value <= gene.lower + reach) return Bound::lower;
    if (value >= gene.upper - reach) return Bound::upper;
    return std::nullopt;
}

const char* name_of(Origin origin) {
    constexpr std::array names{"none",  "baseline", "random",
                               "elite", "child",    "sample"};
    const auto number = static_cast<std::size_t>(origin);
    return number < names.size() ? names[number] : "unknown";
}

}  // namespace ideotype
