// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "campaign.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

//! @param prefix name of the component, with which gene names begin
void append_genes(GeneSpace& genes, const Crop& crop,
                  const std::vector<Range>& bounds, const TraitSet& free,
                  const std::string& prefix) {
    std::size_t i = 0;
    for (const TraitNumber& number : trait_numbers(crop)) {
        const Trait& trait = crop.traits[number.trait];
        const auto& [lower, upper] = bounds.at(i++);
        std::string name = trait.name;
        if (number.leaf > 0)
            name = fmt::format("leaf{:02}_{}", number.leaf, trait.name);
        if (number.point > 0)
            name = fmt::format("{}_{}", trait.name, number.point);
        const bool is_whole =
            lower == trait.range.lower && upper == trait.range.upper;
        const bool is_free = std::ranges::find(free, trait.name) != free.end();
        genes.push_back({prefix + name, trait.unit, lower, upper,
                         trait.is_circular && is_whole, is_free,
                         prefix + trait.name, number.leaf});
    }
}

}  // namespace

Genome baseline_genome(const Campaign& campaign) {
    Genome genome = baseline_numbers(campaign.crop);
    for (const ComponentEntry& component : campaign.components)
        if (!component.free.empty()) {
            const Genome own = baseline_numbers(component.crop);
            genome.insert(genome.end(), own.begin(), own.end());
        }
    return genome;
}

Plants grow(const Campaign& campaign, const Genome& genome) {
    if (const std::size_t count = count_genes(campaign); genome.size() != count)
        throw Error(
            fmt::format("a genome of {} genes does not describe a plant of "
                        "this campaign (its traits have {} numbers)",
                        genome.size(), count));
    auto next = genome.begin();
    const auto grown = [&](const Crop& crop, std::size_t count) {
        const auto first = next;
        next += static_cast<std::ptrdiff_t>(count);
        return grow(crop, std::vector<double>(first, next));
    };
    Plants plants{grown(campaign.crop, campaign.bounds.size())};
    for (const ComponentEntry& component : campaign.components)
        plants.push_back(component.free.empty()
                             ? component.crop.baseline
                             : grown(component.crop, component.bounds.size()));
    return plants;
}

Spacing spacing_of(const Campaign& campaign, const Case& chosen,
                   std::size_t component) {
    Spacing spacing = chosen.spacing;
    if (component == 0) return spacing;
    const Standing& standing = campaign.components.at(component - 1).standing;
    if (standing.plants > 0)
        spacing.plant *=
            static_cast<double>(campaign.spec.field.plants) / standing.plants;
    return spacing;
}

Plant at_density(const Campaign& campaign, const Case& chosen,
                 std::size_t component, const Plant& plant) {
    return respond(plant,
                   spacing_of(campaign, chosen, component).plants_per_area());
}

std::size_t count_genes(const Campaign& campaign) {
    std::size_t count = campaign.bounds.size();
    for (const ComponentEntry& each : campaign.components)
        if (!each.free.empty()) count += each.bounds.size();
    return count;
}

GeneSpace gene_space(const Campaign& campaign, const Case& chosen) {
    GeneSpace genes;
    append_genes(genes, campaign.crop, campaign.bounds, chosen.traits, "");
    for (const ComponentEntry& component : campaign.components)
        if (!component.free.empty())
            append_genes(genes, component.crop, component.bounds,
                         component.free, component.name + '.');
    return genes;
}

GeneSpace search_genes(const Campaign& campaign, const Case& chosen) {
    GeneSpace genes = gene_space(campaign, chosen);
    for (Gene& gene : genes)
        gene.is_free = gene.is_free && campaign.varied.has_traits;
    for (const KeyFactor& factor : campaign.varied.keys) {
        const auto [lower, upper] = bounds_of(factor);
        genes.push_back({factor.key, factor.unit, lower, upper, false, true,
                         factor.key, 0, factor.kind,
                         mapped(factor.values, &TomlValue::text)});
    }
    return genes;
}

}  // namespace ideotype
