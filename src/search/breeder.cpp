// SPDX-License-Identifier: Apache-2.0
#include "breeder.hpp"

#include <tuple>

#include "random_search.hpp"
#include "variation.hpp"

namespace ideotype {

Breeder::Breeder(const GaSettings& settings, SearchSpace space,
                 std::uint64_t seed)
    : settings_(settings), space_(std::move(space)), seed_(seed) {}

Candidate Breeder::founder(std::uint32_t generation, std::uint32_t slot) const {
    if (generation == 0 && slot == 0)
        return {space_.baseline, Origin::baseline};
    return {random_genome(space_, seed_, generation, slot), Origin::random};
}

std::pair<Candidate, Candidate> Breeder::children(const Contest& contest,
                                                  std::uint32_t generation,
                                                  std::uint32_t slot) const {
    RandomStream selection(seed_, Purpose::selection, generation, slot);
    const Parent mother = contest(selection);
    const Parent father = contest(selection);
    Candidate first{mother.individual.candidate.genome,
                    Origin::child,
                    {mother.row, father.row}};
    Candidate second{father.individual.candidate.genome,
                     Origin::child,
                     {father.row, mother.row}};
    RandomStream crossover(seed_, Purpose::crossover, generation, slot);
    if (crossover.uniform() < settings_.crossover_probability)
        for (std::size_t i = 0; i < space_.genes.size(); ++i) {
            const bool is_crossed = crossover.uniform() < 0.5;
            const double u = crossover.uniform();
            const bool is_swapped = crossover.uniform() < 0.5;
            if (!space_.genes[i].is_free || !is_crossed) continue;
            std::tie(first.genome[i], second.genome[i]) =
                cross(space_.genes[i], first.genome[i], second.genome[i], u,
                      settings_.crossover_index);
            if (is_swapped) std::swap(first.genome[i], second.genome[i]);
        }
    mutate_genome(first.genome, generation, slot);
    mutate_genome(second.genome, generation, slot + 1);
    return {std::move(first), std::move(second)};
}

void Breeder::mutate_genome(Genome& genome, std::uint32_t generation,
                            std::uint32_t slot) const {
    const double probability = settings_.mutations_per_child /
                               static_cast<double>(count_free(space_.genes));
    RandomStream stream(seed_, Purpose::mutation, generation, slot);
    for (std::size_t i = 0; i < space_.genes.size(); ++i) {
        const Gene& gene = space_.genes[i];
        const bool is_mutated = stream.uniform() < probability;
        const double u = stream.uniform();
        if (gene.is_free && is_mutated)
            genome[i] = mutate(gene, genome[i], u, settings_.mutation_index);
    }
}

}  // namespace ideotype
