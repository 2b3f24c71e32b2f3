// SPDX-License-Identifier: Apache-2.0
#include "bounds.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace ideotype {

namespace {

//! A trait is reported if at least this fraction of its values is at a bound.
//! Without selection, a value would be at one of its two bounds in a tenth of
//! the searches.
constexpr double least_part = 0.2;

BoundCount::Trait& trait_of(std::vector<BoundCount::Trait>& traits,
                            const std::string& name) {
    const auto trait =
        std::ranges::find(traits, name, &BoundCount::Trait::name);
    if (trait != traits.end()) return *trait;
    traits.push_back({name});
    return traits.back();
}

}  // namespace

std::vector<GeneAtBound> genes_at_bounds(const GeneSpace& genes,
                                         const Genome& plant) {
    std::vector<GeneAtBound> at_bounds;
    for (std::size_t i = 0; i < genes.size(); ++i)
        if (const auto bound = find_bound(genes[i], plant[i]))
            at_bounds.push_back(
                {genes[i].name, *bound, plant[i],
                 *bound == Bound::lower ? genes[i].lower : genes[i].upper});
    return at_bounds;
}

void BoundCount::add(const GeneSpace& genes, const Genome& best) {
    ++searches;
    for (std::size_t i = 0; i < genes.size(); ++i) {
        if (!genes[i].is_free || genes[i].is_circular || genes[i].is_choice())
            continue;
        Trait& trait = trait_of(traits, genes[i].trait);
        ++trait.values;
        if (const auto bound = find_bound(genes[i], best[i]))
            ++(*bound == Bound::lower ? trait.at_lower : trait.at_upper);
    }
}

void BoundCount::add(const BoundCount& others) {
    searches += others.searches;
    for (const Trait& other : others.traits) {
        Trait& trait = trait_of(traits, other.name);
        trait.values += other.values;
        trait.at_lower += other.at_lower;
        trait.at_upper += other.at_upper;
    }
}

std::string BoundCount::in_words() const {
    std::vector<std::string> clauses;
    for (const Trait& trait : traits)
        for (const Bound bound : {Bound::lower, Bound::upper}) {
            const int at =
                bound == Bound::lower ? trait.at_lower : trait.at_upper;
            if (at == 0 || at < least_part * trait.values) continue;
            std::string name = trait.name;
            std::ranges::replace(name, '_', ' ');
            clauses.push_back(
                fmt::format("{} is at its {} bound", name, name_of(bound)));
            if (trait.values == 1) continue;
            clauses.back() +=
                fmt::format(" in {} of {} {}", at, trait.values,
                            trait.values == searches ? "searches" : "values");
        }
    if (clauses.empty()) return "";
    return fmt::format("{}; the gain may be limited by {}",
                       fmt::join(clauses, ", "),
                       clauses.size() == 1 ? "the bound" : "these bounds");
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BoundCount::Trait, name, values, at_lower,
                                   at_upper)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BoundCount, searches, traits)

std::string to_text(const BoundCount& count) {
    return nlohmann::json(count).dump();
}

BoundCount bound_count_of(const std::string& text) {
    return nlohmann::json::parse(text).get<BoundCount>();
}

}  // namespace ideotype
