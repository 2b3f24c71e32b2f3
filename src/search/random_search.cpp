// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <utility>

#include "ideotype/core/random.hpp"
#include "optimizer.hpp"
#include "order.hpp"
#include "sobol_sequence.hpp"

namespace ideotype {

namespace {

//! Genomes that fill the space within their bounds evenly, independent or as
//! points of a SobolSequence. Nothing is learnt from them: it is what any other
//! search has to beat.
class RandomSearch : public Optimizer {
  public:
    RandomSearch(const SearchSettings& settings, SearchSpace space,
                 std::uint64_t seed)
        : population_(static_cast<std::size_t>(settings.population)),
          space_(std::move(space)),
          seed_(seed) {
        if (settings.optimizer == OptimizerKind::sobol)
            sequence_.emplace(seed, count_free(space_.genes));
    }

    std::size_t size(std::uint32_t) const override { return population_; }

    //! Tells that two generations may be under way, so that nobody waits for
    //! the last plants of one.
    std::uint64_t needs(std::uint32_t generation,
                        std::uint32_t) const override {
        return (std::max(generation, 1u) - 1) * population_;
    }

    Candidate propose(std::uint32_t generation, std::uint32_t slot) override {
        if (!sequence_)
            return {random_genome(space_, seed_, generation, slot),
                    Origin::random};
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

    void learn(Individual row) override {
        constexpr std::size_t most = 1000;
        best_.push_back(std::move(row));
        if (best_.size() < 2 * most) return;
        Population best;
        for (const std::uint32_t i : best_distinct(best_, most, space_.senses))
            best.push_back(std::move(best_[i]));
        best_ = std::move(best);
    }

    //! Returns the best distinct of all generations, without parents.
    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<Candidate> best = best_of(best_, count, space_.senses, 0);
        for (Candidate& each : best) each.parents = {no_parent, no_parent};
        return best;
    }

  private:
    std::size_t population_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::optional<SobolSequence> sequence_;  //!< of free genes
    Population best_;  //!< of all, as many as may be asked for
};

}  // namespace

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

std::unique_ptr<Optimizer> make_random_search(const SearchSettings& settings,
                                              SearchSpace space,
                                              std::uint64_t seed) {
    return std::make_unique<RandomSearch>(settings, std::move(space), seed);
}

}  // namespace ideotype
