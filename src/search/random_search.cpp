#include "ideotype/search/random_search.hpp"

#include <utility>

#include "ideotype/core/random.hpp"
#include "ideotype/search/order.hpp"

namespace ideotype {

RandomSearch::RandomSearch(const SearchSettings& settings, SearchSpace space,
                           std::uint64_t seed)
    : population_(static_cast<std::size_t>(settings.population)),
      space_(std::move(space)),
      seed_(seed) {}

std::vector<Candidate> RandomSearch::ask() const {
    std::vector<Candidate> candidates;
    for (std::uint32_t slot = 0; slot < population_; ++slot)
        candidates.push_back(
            {random_genome(space_, seed_, generation_, slot), Origin::random});
    return candidates;
}

void RandomSearch::tell(Population evaluated) {
    ++generation_;
    constexpr std::size_t most = 1000;
    for (Individual& each : evaluated) best_.push_back(std::move(each));
    Population best;
    for (const std::uint32_t i : best_distinct(best_, most, space_.senses))
        best.push_back(std::move(best_[i]));
    best_ = std::move(best);
}

std::vector<Candidate> RandomSearch::best(std::size_t count) const {
    std::vector<Candidate> best = best_of(best_, count, space_.senses);
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
