// SPDX-License-Identifier: Apache-2.0
#include "random_search.hpp"

#include <algorithm>
#include <utility>

#include "ideotype/core/random.hpp"
#include "order.hpp"

namespace ideotype {

RandomSearch::RandomSearch(const SearchSettings& settings, SearchSpace space,
                           std::uint64_t seed)
    : population_(static_cast<std::size_t>(settings.population)),
      space_(std::move(space)),
      seed_(seed) {
    if (settings.optimizer == OptimizerKind::sobol)
        sequence_.emplace(seed, count_free(space_.genes));
}

std::uint64_t RandomSearch::needs(std::uint32_t generation,
                                  std::uint32_t) const {
    return (std::max(generation, 1u) - 1) * population_;
}

Candidate RandomSearch::propose(std::uint32_t generation, std::uint32_t slot) {
    if (!sequence_)
        return {random_genome(space_, seed_, generation, slot), Origin::random};
    const auto point =
        static_cast<std::uint32_t>(generation * population_ + slot);
    Genome genome = space_.baseline;
    std::size_t dimension = 0;
    for (std::size_t i = 0; i < genome.size(); ++i) {
        const Gene& gene = space_.genes[i];
        if (!gene.is_free) continue;
        const double range = gene.upper - gene.lower;
        genome[i] = gene.lower + range * sequence_->at(point, dimension++);
    }
    return {std::move(genome), Origin::random};
}

void RandomSearch::learn(Individual row) {
    constexpr std::size_t most = 1000;
    best_.push_back(std::move(row));
    if (best_.size() < 2 * most) return;
    Population best;
    for (const std::uint32_t i : best_distinct(best_, most, space_.senses))
        best.push_back(std::move(best_[i]));
    best_ = std::move(best);
}

std::vector<Candidate> RandomSearch::best(std::size_t count) const {
    std::vector<Candidate> best = best_of(best_, count, space_.senses, 0);
    for (Candidate& each : best) each.parents = {no_parent, no_parent};
    return best;
}

Genome random_genome(const SearchSpace& space, std::uint64_t seed,
                     std::uint32_t generation, std::uint32_t slot) {
    RandomStream stream(seed, Purpose::initial_population, generation, slot);
    Genome genome = space.baseline;
    for (std::size_t i = 0; i < genome.size(); ++i) {
        const Gene& gene = space.genes[i];
        if (gene.is_free) genome[i] = stream.uniform(gene.lower, gene.upper);
    }
    return genome;
}

}  // namespace ideotype
