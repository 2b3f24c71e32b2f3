// SPDX-License-Identifier: Apache-2.0
#include "gene.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"

namespace ideotype {

std::size_t Gene::count() const {
    IDEOTYPE_EXPECT(is_discrete());
    return static_cast<std::size_t>(upper - lower) + 1;
}

std::size_t count_free(const GeneSpace& genes) {
    return static_cast<std::size_t>(
        std::count_if(genes.begin(), genes.end(),
                      [](const Gene& gene) { return gene.is_free; }));
}

double value_at(const Gene& gene, double share) {
    IDEOTYPE_EXPECT(share >= 0 && share <= 1);
    if (!gene.is_discrete())
        return gene.lower + (gene.upper - gene.lower) * share;
    const auto count = static_cast<double>(gene.count());
    return gene.lower + std::min(std::floor(share * count), count - 1);
}

double share_of(const Gene& gene, double value) {
    IDEOTYPE_EXPECT(gene.upper > gene.lower);
    if (!gene.is_discrete())
        return (value - gene.lower) / (gene.upper - gene.lower);
    return (value - gene.lower + 0.5) / static_cast<double>(gene.count());
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
    if (gene.is_circular) return wrapped(gene, value);
    const double rounded = gene.is_discrete() ? std::round(value) : value;
    return std::clamp(rounded, gene.lower, gene.upper);
}

double other_value(const Gene& gene, double value, double u) {
    IDEOTYPE_EXPECT(gene.is_discrete() && gene.upper > gene.lower);
    IDEOTYPE_EXPECT(u >= 0 && u < 1);
    if (gene.is_choice()) {
        const auto others = static_cast<double>(gene.count() - 1);
        const double other = gene.lower + std::floor(u * others);
        return other < value ? other : other + 1;
    }
    const double next = u < 0.5 ? value - 1 : value + 1;
    return next < gene.lower || next > gene.upper ? 2 * value - next : next;
}

std::string text_of(const Gene& gene, double value) {
    if (gene.values.empty()) return fmt::format("{}", value);
    const auto entry = static_cast<std::size_t>(
        std::clamp(std::round(value), gene.lower, gene.upper) - gene.lower);
    return gene.values.at(entry);
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
    if (gene.is_circular || gene.is_choice() || !gene.is_free)
        return std::nullopt;
    const double reach = bound_margin * (gene.upper - gene.lower);
    if (!(reach > 0)) return std::nullopt;
    if (value <= gene.lower + reach) return Bound::lower;
    if (value >= gene.upper - reach) return Bound::upper;
    return std::nullopt;
}

}  // namespace ideotype
