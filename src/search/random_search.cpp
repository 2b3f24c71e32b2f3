#include "ideotype/search/random_search.hpp"

#include <algorithm>
#include <utility>

#include "ideotype/core/random.hpp"
#include "ideotype/search/order.hpp"

namespace ideotype {

RandomSearch::RandomSearch(const SearchSettings& settings, SearchSpace space,
                           std::uint64_t seed)
    : population_(static_cast<std::size_t>(settings.population)),
      space_(std::move(space)),
      seed_(seed) {}

std::uint64_t RandomSearch::needs(std::uint32_t generation,
                                  std::uint32_t) const {
    return (std::max(generation, 1u) - 1) * population_;
}

Candidate RandomSearch::propose(std::uint32_t generation, std::uint32_t slot) {
    return {random_genome(space_, seed_, generation, slot), Origin::random};
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
