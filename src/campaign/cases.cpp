#include <cctype>

#include <fmt/format.h>

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/hash.hpp"

namespace ideotype {

namespace {

constexpr std::size_t genes_per_leaf = 4;

//! The same for a case however many others there are: all axes are named,
//! also those with one entry.
std::string case_name(const std::string& site, const std::string& day,
                      const std::string& spacing, const std::string& traits,
                      int replicate) {
    std::string name =
        fmt::format("{}_{}_{}_{}_r{}", site, day, spacing, traits, replicate);
    for (char& c : name)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

}  // namespace

std::vector<Case> cases(const Campaign& campaign) {
    std::vector<Case> all;
    for (const Site& site : campaign.sites)
        for (const auto& day : campaign.days)
            for (const auto& spacing : campaign.spacings)
                for (const auto& traits : campaign.trait_sets)
                    for (int r = 1; r <= campaign.replicates; ++r) {
                        Case one;
                        one.index = static_cast<int>(all.size());
                        one.name = case_name(site.name, day.name, spacing.name,
                                             traits.name, r);
                        one.seed = derive_seed(campaign.seed, one.name);
                        one.site = site;
                        one.day = day.value;
                        one.spacing = spacing.value;
                        one.traits = traits.value;
                        one.day_name = day.name;
                        one.spacing_name = spacing.name;
                        one.trait_set_name = traits.name;
                        one.replicate = r;
                        all.push_back(std::move(one));
                    }
    return all;
}

Case case_at(const Campaign& campaign, int index, const std::string& path) {
    const std::vector<Case> all = cases(campaign);
    if (index < 0 || index >= static_cast<int>(all.size()))
        throw Error(fmt::format("there is no case {}; {} has cases 0 to {} "
                                "(see ideotype plan)",
                                index, path, all.size() - 1),
                    ExitCode::usage);
    return all[static_cast<std::size_t>(index)];
}

GeneSpace gene_space(const Campaign& campaign, const Case& chosen) {
    const TraitSet& free = chosen.traits;
    GeneSpace genes;
    int rank = 0;
    for (const LeafBounds& bounds : campaign.bounds) {
        const std::string leaf = fmt::format("leaf{:02}_", ++rank);
        const auto add = [&](const std::string& trait, const std::string& unit,
                             Range range, bool is_free) {
            genes.push_back({leaf + trait, unit, range.lower, range.upper,
                             trait == "azimuth", is_free, trait, rank});
        };
        add("length", "m", bounds.length, free.length);
        add("width", "m", bounds.width, free.width);
        add("insertion_angle", "deg", bounds.insertion_angle,
            free.insertion_angle);
        add("azimuth", "deg", {0, 360}, free.azimuth);
    }
    return genes;
}

Genome to_genome(const std::vector<LeafTraits>& traits) {
    Genome genome;
    genome.reserve(genes_per_leaf * traits.size());
    for (const LeafTraits& leaf : traits)
        genome.insert(genome.end(), {leaf.length, leaf.width,
                                     leaf.insertion_angle, leaf.azimuth});
    return genome;
}

std::vector<LeafTraits> to_traits(const Genome& genome) {
    if (genome.size() % genes_per_leaf != 0)
        throw Error(
            fmt::format("a genome of {} genes is not a plant (each "
                        "leaf has {})",
                        genome.size(), genes_per_leaf));
    std::vector<LeafTraits> traits;
    for (std::size_t i = 0; i < genome.size(); i += genes_per_leaf)
        traits.push_back(
            {genome[i], genome[i + 1], genome[i + 2], genome[i + 3]});
    return traits;
}

}  // namespace ideotype
